// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "display/window.h"
#include "display/xvfb.h"

namespace stagelight {

// A window on a display of its own, and what OpenGL complained of while it was open.
class OpenWindow {
public:
    explicit OpenWindow(const WindowSettings &settings = {.vsync = false}, int depth = 24);

    Window &operator*() { return window_; }
    Window *operator->() { return &window_; }

    // glGetError's, and the debug messages of severity medium and high.
    std::vector<std::string> complaints();
    void forget_complaints() { complaints_.clear(); }

private:
    Xvfb xvfb_;
    Window window_;
    std::vector<std::string> complaints_;
};

// A test with an open window, which fails when OpenGL complains.
class OnDisplay : public testing::Test {
protected:
    void TearDown() override { EXPECT_EQ(window.complaints(), std::vector<std::string>()); }

    OpenWindow window;
};

}  // namespace stagelight
