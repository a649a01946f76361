// SPDX-License-Identifier: MIT
// Which device draws: --list-devices, --device, STAGELIGHT_DEVICE, and what is said without one.
#include <sstream>

#include "cli/program.h"

namespace stagelight::cli {
namespace {

// Both of packages.txt's drivers are there when rusticl is asked for.
const std::string two_devices = "RUSTICL_ENABLE=llvmpipe";

// The names in "0: NAME (PLATFORM, VERSION)", in order.
std::vector<std::string> names_in(const std::string &list) {
    std::vector<std::string> names;
    std::istringstream lines(list);
    for (std::string line; std::getline(lines, line);) {
        const std::string index = std::to_string(names.size()) + ": ";
        const std::size_t platform = line.rfind(" (");
        EXPECT_TRUE(line.starts_with(index) && platform != std::string::npos && line.ends_with(')'))
            << "expected '" << index << "NAME (PLATFORM, VERSION)', found: " << line;
        names.push_back(line.substr(index.size(), platform - index.size()));
    }
    return names;
}

class Stage01Device : public Cli {
protected:
    std::vector<std::string> devices() const {
        const Outcome outcome = run("01_primitives", Start{{"--list-devices"}, {two_devices}});
        expect_done(outcome);
        return names_in(outcome.out);
    }
    // Draws with the options, and returns the device that did: the first line that is said.
    std::string drawn_by(std::vector<std::string> options,
                         std::vector<std::string> environment = {}) const {
        options.insert(options.end(), {"--size", "1x1", "--out", "a.png"});
        environment.push_back(two_devices);
        const Outcome outcome = run("01_primitives", Start{options, environment});
        expect_done(outcome);
        return outcome.out.substr(0, outcome.out.find('\n'));
    }
    static std::string find(const std::vector<std::string> &names, const std::string &part) {
        for (const std::string &name : names) {
            if (name.find(part) != std::string::npos) {
                return name;
            }
        }
        ADD_FAILURE() << "expected a device whose name holds " << part;
        return "";
    }
};

TEST_F(Stage01Device, ListHasBothDrivers) {
    const std::vector<std::string> names = devices();
    EXPECT_NE(find(names, "pthread"), find(names, "llvmpipe"));
    EXPECT_EQ(files(), std::vector<std::string>{});
}

TEST_F(Stage01Device, IsTakenByItsIndex) {
    const std::vector<std::string> names = devices();
    for (std::size_t i = 0; i < names.size(); ++i) {
        EXPECT_EQ(drawn_by({"--device", std::to_string(i)}), names[i]);
    }
}

TEST_F(Stage01Device, IsTakenByPartOfItsNameInAnyCase) {
    const std::vector<std::string> names = devices();
    EXPECT_EQ(drawn_by({"--device", "llvmpipe"}), find(names, "llvmpipe"));
    EXPECT_EQ(drawn_by({"--device", "PThread"}), find(names, "pthread"));
}

TEST_F(Stage01Device, IsTakenByItsType) {
    EXPECT_EQ(drawn_by({"--device", "cpu"}), find(devices(), "pthread"));
}

TEST_F(Stage01Device, ComesFromTheEnvironmentUnlessTheOptionSaysElse) {
    const std::vector<std::string> names = devices();
    const std::string variable = "STAGELIGHT_DEVICE=llvmpipe";
    EXPECT_EQ(drawn_by({}, {variable}), find(names, "llvmpipe"));
    EXPECT_EQ(drawn_by({"--device", "pthread"}, {variable}), find(names, "pthread"));
}

// The list of those there are is on the lines that follow.
TEST_F(Stage01Device, ThatIsNotThereIsToldWithTheList) {
    const Outcome list = run("01_primitives", {"--list-devices"});
    const auto expect_list = [&](const Start &start, const std::string &name) {
        const Outcome outcome = run("01_primitives", start);
        EXPECT_EQ(outcome.code, machines_lack) << outcome;
        EXPECT_EQ(outcome.out, "");
        EXPECT_TRUE(outcome.err.starts_with("error: no OpenCL device '" + name + "'; there are:\n"
                                            + list.out))
            << outcome;
        EXPECT_EQ(files(), std::vector<std::string>{});
    };
    expect_list({{"--device", "abacus"}}, "abacus");
    expect_list({{"--device", "99"}}, "99");
    expect_list({{"--device", "-1"}}, "-1");
    expect_list({{}, {"STAGELIGHT_DEVICE=abacus"}}, "abacus");
}

TEST_F(Stage01Device, WithoutAnyTheRemedyIsNamed) {
    std::filesystem::create_directory(folder.path() / "no_drivers");
    const std::string none = "OCL_ICD_VENDORS=" + (folder.path() / "no_drivers").string();
    const std::string remedy =
        "no OpenCL device: install a driver (Debian: apt-get install pocl-opencl-icd)";
    expect_one_line(run("01_primitives", Start{{"--size", small}, {none}}), machines_lack, remedy);
    EXPECT_EQ(files(), std::vector<std::string>{"no_drivers"});
    const Outcome list = run("01_primitives", Start{{"--list-devices"}, {none}});
    expect_done(list);
    EXPECT_EQ(list.out, remedy + '\n');
}

}  // namespace
}  // namespace stagelight::cli
