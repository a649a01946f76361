// SPDX-License-Identifier: MIT
#include "display/input.h"

namespace stagelight {

const std::vector<std::string> &key_help() {
    static const std::vector<std::string> lines = {
        "W A S D   move forward, left, back, right",
        "space, C  move up, down",
        "drag      look around (left mouse button)",
        "scroll    move faster or slower",
        "R         reload the kernels",
        "P         save a screenshot",
        "F1        show or hide these keys",
        "Esc       leave",
    };
    return lines;
}

}  // namespace stagelight
