// SPDX-License-Identifier: MIT
#include <cstdlib>
#include <filesystem>

#include <malloc.h>

#include "display/gl.h"
#include "display/open_window.h"
#include "display/x_client.h"
#include "scene/errors.h"

namespace stagelight {
namespace {

class Window : public OnDisplay {};

// Ends the process as run_main would, so that a test can look at both message and code.
[[noreturn]] void open_and_exit(const WindowSettings &settings) {
    try {
        const stagelight::Window window(settings);
    } catch (const MachineError &error) {
        std::fputs(error.what(), stderr);
        std::exit(exit_machine_error);
    }
    std::exit(exit_done);
}

long entries(const char *folder) {
    return std::distance(std::filesystem::directory_iterator(folder), {});
}

std::size_t bytes_allocated() {
    const struct mallinfo2 info = mallinfo2();
    return info.uordblks + info.hblkhd;
}

TEST_F(Window, HasTheSizeAndTitleAskedForAndACoreContext) {
    EXPECT_EQ(window->framebuffer_size(), glm::ivec2(640, 384));
    EXPECT_EQ(window->content_scale(), 1);
    EXPECT_FALSE(window->closed());
    GLint profile = 0;
    glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
    EXPECT_EQ(profile, GL_CONTEXT_CORE_PROFILE_BIT);
    EXPECT_GE(epoxy_gl_version(), 33);
    window->set_title("12.3 ms");
    EXPECT_NO_THROW(XClient("12.3 ms"));
}

TEST_F(Window, SaysWhenOpenGLComplains) {  // so that OnDisplay can fail
    glEnable(0);
    EXPECT_EQ(window.complaints().size(), 2U);
    window.forget_complaints();
}

TEST_F(Window, AnotherBesideItIsAMistake) {
    EXPECT_THROW(stagelight::Window({}), std::logic_error);
    EXPECT_EQ(window->framebuffer_size(), glm::ivec2(640, 384));
    EXPECT_EQ(window->poll().trouble, "");
}

TEST_F(Window, ComplaintsOfGlfwAreHandedOn) {
    glfwWindowHint(-1, 0);
    EXPECT_NE(window->poll().trouble, "");
    EXPECT_EQ(window->poll().trouble, "");
}

TEST(WindowApi, IsGlxUnlessEglIsAskedFor) {
    EXPECT_EQ(OpenWindow()->api(), ContextApi::native);
    EXPECT_EQ(OpenWindow({.api = ContextApi::egl})->api(), ContextApi::egl);
}

TEST(WindowColors, AreThoseOfTheScreen) {
    EXPECT_EQ(OpenWindow({}, 24)->color_bits(), 8);
    EXPECT_EQ(OpenWindow({}, 30)->color_bits(), 10);
    EXPECT_EQ(OpenWindow({.api = ContextApi::egl}, 30)->color_bits(), 10);
}

TEST(WindowErrors, NoDisplay) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    unsetenv("DISPLAY");
    unsetenv("WAYLAND_DISPLAY");
    EXPECT_EXIT(open_and_exit({}), testing::ExitedWithCode(exit_machine_error),
                "^no display for a window \\(.+\\): .*Xvfb.*xvfb-run.*--display none$");
    setenv("DISPLAY", ":12345", 1);
    EXPECT_EXIT(open_and_exit({}), testing::ExitedWithCode(exit_machine_error),
                "^no display for a window \\(.+\\): .*Xvfb.*xvfb-run.*--display none$");
}

TEST(WindowErrors, NoOpenGLAtAll) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    const Xvfb xvfb(8);  // too few colours for Mesa
    EXPECT_EXIT(open_and_exit({}), testing::ExitedWithCode(exit_machine_error),
                "^no OpenGL for a window \\(.*GLX.*\\): .*--display none$");
}

// Mesa reads these variables once in a process, so each has its own. Newer ones warn of EGL first.
TEST(WindowErrors, OpenGLIsTooOld) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    const Xvfb xvfb;
    for (const ContextApi api : {ContextApi::native, ContextApi::egl}) {
        setenv("MESA_GL_VERSION_OVERRIDE", "2.1", 1);
        setenv("MESA_GLSL_VERSION_OVERRIDE", "120", 1);
        EXPECT_EXIT(open_and_exit({.api = api}), testing::ExitedWithCode(exit_machine_error),
                    "(^|\n)a window needs OpenGL 3.3 or newer, found 2.1 .*: .*--display none$");
        setenv("MESA_GL_VERSION_OVERRIDE", "3.2", 1);
        setenv("MESA_GLSL_VERSION_OVERRIDE", "150", 1);
        EXPECT_EXIT(open_and_exit({.api = api}), testing::ExitedWithCode(exit_machine_error),
                    "(^|\n)a window needs OpenGL 3.3 or newer, found 3.2 .*: .*--display none$");
    }
    unsetenv("MESA_GL_VERSION_OVERRIDE");
    unsetenv("MESA_GLSL_VERSION_OVERRIDE");
}

// The first few fill caches of the drivers. GLFW and Mesa without us lose 10 KiB with each, newer
// ones 120; the pixels of one window are 960.
TEST(WindowLeaks, NothingOverFiftyWindows) {
    const Xvfb xvfb;
    long files = 0;
    long threads = 0;
    std::size_t bytes = 0;
    for (int i = 0; i < 50; ++i) {
        {
            stagelight::Window window({.vsync = false});
            window.swap();
            EXPECT_EQ(window.poll().trouble, "");
        }
        if (i == 9) {
            files = entries("/proc/self/fd");
            threads = entries("/proc/self/task");
            bytes = bytes_allocated();
        }
    }
    EXPECT_EQ(entries("/proc/self/fd"), files);
    EXPECT_EQ(entries("/proc/self/task"), threads);
    EXPECT_LE(bytes_allocated(), bytes + 40 * 240 * 1024);
}

}  // namespace
}  // namespace stagelight
