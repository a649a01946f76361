// SPDX-License-Identifier: MIT
// PoCL's folder of compiled kernels: where it can't be made, is full, or holds what is damaged, the
// picture is drawn all the same, and one line says why.
#include <algorithm>
#include <fstream>

#include "cli/program.h"

namespace stagelight::cli {
namespace {

namespace fs = std::filesystem;
using Files = std::vector<std::string>;

class Stage01KernelCache : public Cli {
protected:
    Stage01KernelCache() { fs::create_directory(folder.path() / "temporary"); }

    Outcome draw(std::vector<std::string> environment) const {
        environment.push_back("TMPDIR=" + (folder.path() / "temporary").string());
        environment.emplace_back("ASAN_OPTIONS=detect_leaks=0:verify_asan_link_order=0");
        return run("01_primitives", Start{{"--size", small, "--out", "a.png"}, environment});
    }
    // Drawn, with `text` in the one warning there is, and nothing left behind.
    void expect_drawn(const Outcome &outcome, const std::string &text) const {
        EXPECT_EQ(outcome.code, 0) << outcome;
        const std::size_t warning = outcome.err.find("warning: ");
        ASSERT_NE(warning, std::string::npos) << outcome;
        expect_part(outcome.err, text);
        expect_part(outcome.err, "they go to a temporary folder, unless POCL_CACHE_DIR names");
        EXPECT_EQ(outcome.err.find("warning: ", warning + 1), std::string::npos) << outcome;
        EXPECT_TRUE(fs::is_empty(folder.path() / "temporary"));
        EXPECT_TRUE(exists(folder.path() / "a.png"));
    }
};

TEST_F(Stage01KernelCache, ThatCantBeMadeIsToldWithTheCause) {
    const fs::path file = folder.write("file", "");
    expect_drawn(draw({"POCL_CACHE_DIR=" + file.string() + "/cache"}),
                 "compiled kernels can't be kept in " + file.string() + "/cache: Not a directory");
    expect_drawn(draw({"POCL_CACHE_DIR=/proc/cache"}), "kept in /proc/cache: No such file");
}

TEST_F(Stage01KernelCache, ThatIsFullIsToldWithTheCause) {
    const std::string cache = (folder.path() / "cache").string();
    expect_drawn(draw({"POCL_CACHE_DIR=" + cache, "LD_PRELOAD=" STAGELIGHT_FAULTS,
                       "STAGELIGHT_FAULT=statvfs"}),
                 "can't be kept in " + cache + ": No space left on device");
}

// However it is damaged: PoCL aborts, finds no kernel, or takes it for none of its own. PoCL 7.1
// makes a shared object that it can't load anew.
TEST_F(Stage01KernelCache, ThatIsDamagedIsToldAndAvoided) {
    const fs::path cache = folder.path() / "cache";
    const std::string variable = "POCL_CACHE_DIR=" + cache.string();
    const auto damage = [&](const std::string &extension, const std::string &text) {
        fs::remove_all(cache);
        expect_done(draw({variable}));
        std::vector<fs::path> damaged;
        for (const auto &entry : fs::recursive_directory_iterator(cache)) {
            if (entry.is_regular_file() && entry.path().extension() == extension) {
                std::ofstream(entry.path()) << text;
                damaged.push_back(entry.path());
            }
        }
        EXPECT_FALSE(damaged.empty()) << extension;
        SCOPED_TRACE(extension + " " + text);
        const Outcome outcome = draw({variable});
        if (!damaged.empty() && fs::file_size(damaged[0]) != text.size()) {
            expect_done(outcome);
        } else {
            expect_drawn(outcome, "compiled kernels in " + cache.string() + " may be damaged");
        }
    };
    damage(".so", "junk");
    damage(".bc", "");
    for (const auto &entry : fs::recursive_directory_iterator(cache)) {
        if (entry.path().extension() == ".so") {
            fs::remove(entry.path());
        }
    }
    damage(".bc", "junk");
}

TEST_F(Stage01KernelCache, ADriverThatAlwaysEndsIsToldOnce) {
    for (const char *fault : {"STAGELIGHT_FAULT=abort", "STAGELIGHT_FAULT=exit"}) {
        const Outcome outcome = draw({"LD_PRELOAD=" STAGELIGHT_FAULTS, fault});
        EXPECT_EQ(outcome.code, machines_lack) << outcome;
        EXPECT_TRUE(outcome.err.ends_with("error: the OpenCL driver ended the program, see above "
                                          "for its own words; try another --device "
                                          "(--list-devices)\n"))
            << outcome;
        EXPECT_EQ(files(), Files{"temporary"});
    }
}

}  // namespace
}  // namespace stagelight::cli
