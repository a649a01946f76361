// SPDX-License-Identifier: MIT
// Which device draws: --list-devices, --device, STAGELIGHT_DEVICE, and what is said without one.
#include <sstream>

#include "cli/program.h"

namespace stagelight::cli {
namespace {

// Both drivers of the tests' packages are there when rusticl is asked for.
const std::string two_devices = "RUSTICL_ENABLE=llvmpipe";

struct Listed {
    std::string name;
    std::string line;  // "0: NAME (PLATFORM, VERSION)"
};

std::vector<Listed> devices_in(const std::string &list) {
    std::vector<Listed> devices;
    std::istringstream lines(list);
    for (std::string line; std::getline(lines, line);) {
        const std::string index = std::to_string(devices.size()) + ": ";
        const std::size_t platform = line.rfind(" (");
        EXPECT_TRUE(line.starts_with(index) && platform != std::string::npos && line.ends_with(')'))
            << "expected '" << index << "NAME (PLATFORM, VERSION)', found: " << line;
        devices.push_back({line.substr(index.size(), platform - index.size()), line});
    }
    return devices;
}

class Stage01Device : public Cli {
protected:
    std::vector<Listed> devices() const {
        const Outcome outcome = run("01_primitives", Start{{"--list-devices"}, {two_devices}});
        expect_done(outcome);
        return devices_in(outcome.out);
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
    static std::string find(const std::vector<Listed> &devices, const std::string &part) {
        for (const Listed &device : devices) {
            if (device.line.find(part) != std::string::npos) {
                return device.name;
            }
        }
        ADD_FAILURE() << "expected a device whose line holds " << part;
        return "";
    }
};

TEST_F(Stage01Device, ListHasBothDrivers) {
    const std::vector<Listed> listed = devices();
    EXPECT_NE(find(listed, "PoCL"), find(listed, "llvmpipe"));
    EXPECT_EQ(files(), std::vector<std::string>{});
}

TEST_F(Stage01Device, IsTakenByItsIndex) {
    const std::vector<Listed> listed = devices();
    for (std::size_t i = 0; i < listed.size(); ++i) {
        EXPECT_EQ(drawn_by({"--device", std::to_string(i)}), listed[i].name);
    }
}

TEST_F(Stage01Device, IsTakenByPartOfItsLineInAnyCase) {
    const std::vector<Listed> listed = devices();
    EXPECT_EQ(drawn_by({"--device", "llvmpipe"}), find(listed, "llvmpipe"));
    EXPECT_EQ(drawn_by({"--device", "portable COMPUTING"}), find(listed, "PoCL"));
}

TEST_F(Stage01Device, IsTakenByItsType) {
    EXPECT_EQ(drawn_by({"--device", "cpu"}), find(devices(), "PoCL"));
}

TEST_F(Stage01Device, ComesFromTheEnvironmentUnlessTheOptionSaysElse) {
    const std::vector<Listed> listed = devices();
    const std::string variable = "STAGELIGHT_DEVICE=llvmpipe";
    EXPECT_EQ(drawn_by({}, {variable}), find(listed, "llvmpipe"));
    EXPECT_EQ(drawn_by({"--device", "pocl"}, {variable}), find(listed, "PoCL"));
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
