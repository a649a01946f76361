// SPDX-License-Identifier: MIT
// --window and --display: the fallback chain as a user sees it.
#include <algorithm>
#include <fstream>

#include <nlohmann/json.hpp>

#include "cli/picture_file.h"
#include "cli/program.h"
#include "display/xvfb.h"

namespace stagelight::cli {
namespace {

class Stage07WithoutDisplay : public Cli {};

class Stage07Window : public Cli {
protected:
    // With a display, and with what else is asked for.
    Outcome show(const std::string &stage, std::vector<std::string> arguments,
                 std::vector<std::string> environment = {}) const {
        arguments.insert(arguments.end(), {"--size", small, "--device", "pocl"});
        environment.push_back("DISPLAY=" + xvfb.display());
        return run(stage, Start{arguments, environment});
    }
    nlohmann::json stats() const {
        std::ifstream file(folder.path() / "stats.json");
        return nlohmann::json::parse(file).at("display");
    }
    PictureFile picture(const std::string &name) const {
        return read_picture_file(folder.path() / name);
    }

    Xvfb xvfb;
    const std::string layer = std::string("OPENCL_LAYERS=") + STAGELIGHT_LAYER;
};

TEST_F(Stage07WithoutDisplay, AWindowThatIsDemandedIsTheMachinesLack) {
    const Outcome outcome = run("01_primitives", {"--window", "--size", small});
    expect_one_line(outcome, machines_lack, "Xvfb");
    expect_part(outcome.err, "--display none");
    EXPECT_EQ(files(), std::vector<std::string>{});
}

TEST_F(Stage07WithoutDisplay, TheChainEndsAtAPicture) {
    for (const char *path : {"auto", "shared", "copy"}) {
        const Outcome outcome = run("01_primitives", {"--display", path, "--size", small});
        expect_done(outcome);
        expect_part(outcome.out, "display: none: no display");
        expect_part(outcome.out, "wrote out/01_primitives.png\n");
    }
}

TEST_F(Stage07WithoutDisplay, Stage07DrawsAPicture) {
    const Outcome outcome = run("07_interop", {"--size", small, "--stats", "stats.json"});
    expect_done(outcome);
    expect_part(outcome.out, "display: none: no display");
    expect_part(outcome.out, "wrote out/07_interop.png\n");
}

TEST_F(Stage07WithoutDisplay, OptionsThatContradictAreRefused) {
    expect_one_line(run("01_primitives", {"--window", "--display", "none"}), users_mistake,
                    "--window and --display none");
    expect_one_line(run("01_primitives", {"--display", "screen"}), users_mistake, "--display");
    expect_one_line(run("01_primitives", {"--texture", "rgba8"}), users_mistake, "--texture");
    for (const char *scale : {"0.5", "65", "nan", "two"}) {
        expect_one_line(run("01_primitives", {"--scale", scale}), users_mistake, "--scale");
    }
    expect_one_line(run("01_primitives", {"--window", "--scale", "64", "--size", "1000x1000"}),
                    users_mistake,
                    "--scale 64: the window would be 64000x64000 pixels, expected 16384 at most");
}

TEST_F(Stage07Window, ShowsOnEachPathWhatIsDrawnWithoutOne) {
    expect_done(show("07_interop", {"--out", "none.exr"}));
    for (const std::string path : {"shared", "copy"}) {
        const Outcome outcome = show("07_interop",
                                     {"--display", path, "--frames", "60", "--out", path + ".exr",
                                      "--stats", "stats.json", "--verbose"},
                                     {layer});
        expect_done(outcome);
        expect_part(outcome.out, "display: " + path + ": ");
        EXPECT_EQ(largest_difference(picture("none.exr"), picture(path + ".exr")), 0) << path;
        EXPECT_EQ(stats().at("path"), path);
        EXPECT_EQ(stats().at("framebuffer"), nlohmann::json({32, 20}));
        EXPECT_EQ(stats().at("timeline").size(), 8);
        expect_part(outcome.out, "from start to picture: ");
    }
}

// A frame is a picture with all of its samples, whether there is a window or not.
TEST_F(Stage07Window, AddsSamplesOnEachPathAsWithoutOne) {
    expect_done(show("07_interop", {"--out", "none.exr", "--samples", "5"}));
    for (const std::string path : {"shared", "copy"}) {
        expect_done(show("07_interop",
                         {"--display", path, "--frames", "2", "--samples", "5", "--out",
                          path + ".exr", "--stats", "stats.json"},
                         {layer}));
        EXPECT_EQ(largest_difference(picture("none.exr"), picture(path + ".exr")), 0) << path;
        EXPECT_EQ(stats().at("path"), path);
        EXPECT_EQ(stats().at("timeline").size(), 2);
    }
}

// Without cl_khr_gl_event the host waits for OpenGL, and the picture is the same.
TEST_F(Stage07Window, SharesWithoutEventsToo) {
    expect_done(show("07_interop", {"--out", "none.exr"}));
    const Outcome outcome =
        show("07_interop", {"--display", "shared", "--frames", "3", "--out", "shared.exr"},
             {layer, "STAGELIGHT_LAYER_GL_EVENT=0"});
    expect_done(outcome);
    expect_part(outcome.out, "display: shared: ");
    EXPECT_EQ(largest_difference(picture("none.exr"), picture("shared.exr")), 0);
}

TEST_F(Stage07Window, ADeviceThatCannotShareCopies) {
    const Outcome outcome =
        show("01_primitives", {"--window", "--frames", "3", "--stats", "stats.json"});
    expect_done(outcome);
    expect_part(outcome.out, "has no cl_khr_gl_sharing\ndisplay: copy: ");
    EXPECT_EQ(stats().at("path"), "copy");
    expect_part(stats().at("reason"), "no shared: ");
    EXPECT_EQ(files(), std::vector<std::string>{"stats.json"}) << "a window writes no picture";
}

// Frames are shown before it is lost. No other path works then, nor does a picture without a
// window.
TEST_F(Stage07Window, ADeviceThatIsLostIsTheMachinesLack) {
    for (const std::string path : {"shared", "copy"}) {
        const Outcome outcome = show(
            "07_interop",
            {"--display", path, "--frames", "60", "--out", "a.exr", "--stats", "stats.json"},
            {layer, "LD_PRELOAD=" STAGELIGHT_FAULTS, "STAGELIGHT_FAULT=clEnqueueNDRangeKernel",
             "STAGELIGHT_FAULT_AFTER=20", "ASAN_OPTIONS=detect_leaks=0:verify_asan_link_order=0"});
        EXPECT_EQ(outcome.code, machines_lack) << outcome;
        expect_part(outcome.out, "display: " + path + ": ");
        expect_part(outcome.out, "display: no " + path + ": clEnqueueNDRangeKernel failed");
        expect_part(outcome.out, "display: no copy: clEnqueueNDRangeKernel failed");
        expect_part(outcome.err, "try another --device");
        EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome;
        EXPECT_EQ(files(), std::vector<std::string>{});
    }
}

TEST_F(Stage07Window, ScaleMakesTheWindowLargerThanThePicture) {
    expect_done(show("01_primitives", {"--window", "--frames", "2", "--scale", "2.5", "--out",
                                       "a.exr", "--stats", "stats.json"}));
    EXPECT_EQ(picture("a.exr").width, 32);
    EXPECT_EQ(stats().at("framebuffer"), nlohmann::json({80, 50}));
}

TEST_F(Stage07Window, TheTexturesFormatIsTheUsers) {
    expect_done(show("01_primitives", {"--out", "none.exr"}));
    expect_done(show("01_primitives",
                     {"--window", "--frames", "2", "--texture", "rgba16f", "--out", "half.exr"}));
    const float difference = largest_difference(picture("none.exr"), picture("half.exr"));
    EXPECT_GT(difference, 0);
    EXPECT_LE(difference, 0.00098F);
}

const std::string no_buffer_storage = "MESA_EXTENSION_OVERRIDE=-GL_ARB_buffer_storage";

TEST_F(Stage07Window, OpenGlThatKeepsNoBufferMappedDrawsAPicture) {
    const std::vector<std::string> old{"MESA_GL_VERSION_OVERRIDE=3.3", no_buffer_storage};
    const Outcome outcome = show("01_primitives", {"--display", "auto"}, old);
    expect_done(outcome);
    expect_part(outcome.out, "display: no copy: OpenGL has no ARB_buffer_storage");
    expect_part(outcome.out, "wrote out/01_primitives.png\n");
    const Outcome demanded = show("01_primitives", {"--window"}, old);
    EXPECT_EQ(demanded.code, machines_lack) << demanded;
    expect_part(demanded.err, "--display none");
}

TEST_F(Stage07Window, OpenGlThatIsTooOldDrawsAPicture) {
    const std::vector<std::string> old{"MESA_GL_VERSION_OVERRIDE=2.1"};
    const Outcome outcome = show("01_primitives", {"--display", "auto"}, old);
    expect_done(outcome);
    expect_part(outcome.out, "display: none: ");
    expect_part(outcome.out, "3.3");
    expect_one_line(show("01_primitives", {"--window"}, old), machines_lack, "3.3");
}

}  // namespace
}  // namespace stagelight::cli
