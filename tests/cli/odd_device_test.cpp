// SPDX-License-Identifier: MIT
// Devices that lack something: each gives way to the next one, with one line, unless it was asked
// for. Rusticl's device is made odd, and says that it is a GPU, which is tried first.
#include <algorithm>

#include "cli/picture_file.h"
#include "cli/program.h"

namespace stagelight::cli {
namespace {

const std::string scenes = std::string(STAGELIGHT_SOURCE_DIR) + "/scenes/";

class OddDevice : public Cli {
protected:
    Outcome draw(const std::string &stage, const std::string &odd,
                 std::vector<std::string> arguments, const std::string &device = "llvmpipe") const {
        arguments.insert(arguments.end(), {"--size", small, "--out", "a.exr"});
        return run(stage, Start{arguments,
                                {"LD_PRELOAD=" STAGELIGHT_FAULTS, "RUSTICL_ENABLE=llvmpipe",
                                 "STAGELIGHT_ODD_DEVICE=" + odd + ":" + device,
                                 "ASAN_OPTIONS=detect_leaks=0:verify_asan_link_order=0"}});
    }
    static std::string first_line(const std::string &text) {
        return text.substr(0, text.find('\n'));
    }
    // Drawn by PoCL, after one line that begins so.
    static void expect_passed_over(const Outcome &outcome, const std::string &begin,
                                   const std::string &end) {
        EXPECT_EQ(outcome.code, 0) << outcome;
        EXPECT_EQ(first_line(outcome.out).find("llvmpipe"), std::string::npos) << outcome;
        EXPECT_TRUE(outcome.err.starts_with("warning: llvmpipe")) << outcome;
        expect_part(outcome.err, begin);
        EXPECT_TRUE(outcome.err.ends_with(end + '\n')) << outcome;
        EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome;
    }
};

using Stage01OddDevice = OddDevice;
using Stage06OddDevice = OddDevice;
using Stage10OddDevice = OddDevice;

TEST_F(Stage01OddDevice, BelowOpenCl12IsPassedOver) {
    expect_passed_over(draw("01_primitives", "opencl_1_1", {}), " has OpenCL 1.1 Mesa 22.3.6, ",
                       "expected 1.2 or newer: passed over");
    expect_passed_over(draw("01_primitives", "opencl_c_1_1", {}), " has OpenCL C 1.1, ",
                       "expected 1.2 or newer: passed over");
}

TEST_F(Stage01OddDevice, BelowOpenCl12IsRefusedWhereItWasAskedFor) {
    expect_one_line(draw("01_primitives", "opencl_1_1", {"--device", "gpu"}), machines_lack,
                    "has OpenCL 1.1 Mesa 22.3.6, expected 1.2 or newer; choose another --device");
    EXPECT_EQ(files(), std::vector<std::string>{});
}

TEST_F(Stage01OddDevice, WithoutImagesDrawsWhatHasNoTexture) {
    const Outcome outcome = draw("01_primitives", "no_images", {});
    expect_done(outcome);
    EXPECT_NE(first_line(outcome.out).find("llvmpipe"), std::string::npos) << outcome;
}

TEST_F(Stage06OddDevice, WithoutImagesIsPassedOverForTextures) {
    const std::string scene = scenes + "06_filtering.toml";
    expect_passed_over(draw("06_textures", "no_images", {scene}), " has no images, ",
                       "which textures need: passed over");
    expect_one_line(draw("06_textures", "no_images", {scene, "--device", "llvmpipe"}),
                    machines_lack, "has no images, which textures need; choose another --device");
}

// The line has the first line of the compiler's log.
TEST_F(Stage01OddDevice, ThatDoesNotBuildGivesWay) {
    const Outcome outcome = draw("01_primitives", "no_build", {});
    expect_passed_over(outcome,
                       ": the kernel does not build: ray.cl:7:1: error: an odd compiler; trying ",
                       first_line(outcome.out));
}

TEST_F(Stage01OddDevice, ThatDoesNotBuildEndsWhereItWasAskedFor) {
    const Outcome outcome = draw("01_primitives", "no_build", {"--device", "llvmpipe"});
    EXPECT_EQ(outcome.code, machines_lack) << outcome;
    EXPECT_EQ(outcome.err,
              "error: the kernel does not build; try another --device "
              "(--list-devices):\nray.cl:7:1: error: an odd compiler\nand more of it\n");
    EXPECT_EQ(files(), std::vector<std::string>{});
}

// Every device says that it is one: rusticl takes a minute and more to build packets.
TEST_F(Stage10OddDevice, AGpuWarnsOfWidePackets) {
    const Outcome outcome =
        draw("10_packets", "gpu", {scenes + "02_lights.toml", "--method", "width=4"}, "");
    EXPECT_EQ(outcome.code, 0) << outcome;
    EXPECT_TRUE(outcome.err.starts_with("warning: --method width=4: ")) << outcome;
    EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome;
}

// A driver that has no names of arguments, and one that takes small work-groups alone.
class SameOnOddDriver : public Cli {
protected:
    void expect_same(const std::string &stage, const std::vector<std::string> &arguments,
                     const std::vector<std::string> &environment) const {
        SCOPED_TRACE(stage);
        const auto draw = [&](const char *out, const std::vector<std::string> &variables) {
            std::vector<std::string> all = arguments;
            all.insert(all.end(), {"--size", small, "--out", out});
            expect_done(run(stage, Start{all, variables}));
            return read_picture_file(folder.path() / out);
        };
        EXPECT_EQ(largest_difference(draw("odd.exr", environment), draw("usual.exr", {})), 0);
    }
};

using Stage01NoArgumentNames = SameOnOddDriver;
using Stage03SmallWorkGroups = SameOnOddDriver;
using Stage01ManyThreads = SameOnOddDriver;

TEST_F(Stage01NoArgumentNames, AreKnownByTheirOrder) {
    const std::vector<std::string> no_names{"LD_PRELOAD=" STAGELIGHT_FAULTS,
                                            "STAGELIGHT_FAULT=clGetKernelArgInfo",
                                            "ASAN_OPTIONS=detect_leaks=0:verify_asan_link_order=0"};
    expect_same("01_primitives", {}, no_names);
    expect_same("02_shading_shadows", {}, no_names);
    expect_same("07_interop", {scenes + "07_interop.toml", "--display", "none"}, no_names);
    expect_same("11_full_tracer", {scenes + "07_interop.toml"}, no_names);
    expect_same("11_full_tracer",
                {scenes + "07_interop.toml", "--method", "triangle=moeller_trumbore"}, no_names);
}

TEST_F(Stage03SmallWorkGroups, DrawTheSame) {
    for (const char *limit : {"POCL_MAX_WORK_GROUP_SIZE=32", "POCL_MAX_WORK_GROUP_SIZE=1"}) {
        expect_same("03_reflection_glossy", {}, {limit});
        expect_same("10_packets", {scenes + "02_lights.toml"}, {limit});
    }
}

// More than there are cores: PoCL aborts where each is to have one of its own.
TEST_F(Stage01ManyThreads, DrawTheSame) {
    expect_same("01_primitives", {}, {"POCL_MAX_PTHREAD_COUNT=99"});
}

}  // namespace
}  // namespace stagelight::cli
