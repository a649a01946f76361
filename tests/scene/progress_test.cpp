// SPDX-License-Identifier: MIT
#include "scene/progress.h"

#include <cstdio>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "scene/pty.h"

namespace stagelight {
namespace {

constexpr const char *clear_line = "\r\x1b[K";

void wait_for_enter() {
    std::getchar();
}

TEST(Progress, IsShownOnATerminalAndRemovedWhenDone) {
    AtTerminal terminal([] {
        {
            Progress progress("counting", 4);
            progress.step();
            wait_for_enter();
        }
        std::puts("the end");
    });
    terminal.wait_for("counting [######------------------] 1 of 4, ");
    terminal.enter();
    terminal.wait_for("the end\r\n");
    const std::string &output = terminal.output();
    EXPECT_TRUE(output.starts_with(clear_line)) << "nothing else, and from the line's beginning";
    EXPECT_NE(output.find("counting [######------------------] 1 of 4, "), std::string::npos)
        << output;
    EXPECT_TRUE(output.ends_with(std::string(clear_line) + "the end\r\n")) << output;
}

TEST(Progress, OfOneStepSaysHowLongItTakes) {
    AtTerminal terminal([] {
        const Progress progress("building");
        const Progress inner("one of many");
        wait_for_enter();
    });
    terminal.wait_for(" s");
    EXPECT_TRUE(terminal.output().starts_with(std::string(clear_line) + "building, "))
        << terminal.output();
    EXPECT_EQ(terminal.output().find("one of many"), std::string::npos) << "one at a time";
}

TEST(Progress, MakesWayForALine) {
    AtTerminal terminal([] {
        const Progress progress("counting", 4);
        say("first");
        wait_for_enter();
        say("second");
    });
    terminal.wait_for("counting");
    terminal.enter();
    terminal.wait_for("second\r\n");
    EXPECT_TRUE(terminal.output().starts_with("first\r\n")) << terminal.output();
    EXPECT_NE(terminal.output().find(std::string(clear_line) + "second\r\n"), std::string::npos)
        << terminal.output();
}

// Twice, so that the first has given its place back.
TEST(Progress, OfWhatIsSoonDoneIsNotShown) {
    AtTerminal terminal([] {
        for (int i = 0; i < 2; ++i) {
            const Progress progress("counting", 4);
            usleep(300'000);
        }
        std::puts("the end");
    });
    terminal.wait_for("the end\r\n");
    EXPECT_EQ(terminal.output(), "the end\r\n");
}

TEST(Progress, IsFitToTheTerminal) {
    AtTerminal terminal([] {
        const Progress progress(std::string(500, 'x'));
        wait_for_enter();
    });
    terminal.wait_for(std::string(79, 'x'));
    EXPECT_TRUE(terminal.output().starts_with(clear_line + std::string(79, 'x')));
    EXPECT_EQ(terminal.output().find(std::string(80, 'x')), std::string::npos);
}

TEST(Progress, IsNotForAFile) {
    int ends[2] = {-1, -1};
    ASSERT_EQ(pipe(ends), 0);
    const pid_t child = fork();
    if (child == 0) {
        dup2(ends[1], STDERR_FILENO);
        dup2(ends[1], STDOUT_FILENO);
        {
            Progress progress("counting", 4);
            progress.step();
            usleep(2'500'000);
        }
        _exit(0);
    }
    close(ends[1]);
    char byte = 0;
    EXPECT_EQ(read(ends[0], &byte, 1), 0) << "not a byte";
    close(ends[0]);
    waitpid(child, nullptr, 0);
}

}  // namespace
}  // namespace stagelight
