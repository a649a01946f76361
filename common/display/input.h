// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace stagelight {

// What happened at a window since it was last asked.
struct Input {
    // The key is held, or was tapped in between.
    bool forward = false;
    bool back = false;
    bool left = false;
    bool right = false;
    bool up = false;
    bool down = false;
    // The key was pressed; holding it counts once.
    bool reload = false;
    bool screenshot = false;
    bool help = false;

    glm::dvec2 look{0, 0};      // the way of the mouse while it was dragged: to the right, down
    double scroll = 0;          // notches, positive away from the user
    bool resized = false;       // also when the window was minimised or came back
    bool needs_redraw = false;  // a part of the window was uncovered
    std::string trouble;        // what the window system complained of, a line; most often empty
};

// A line for each key or movement of the mouse that a window knows, ASCII.
const std::vector<std::string> &key_help();

}  // namespace stagelight
