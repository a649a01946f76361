// SPDX-License-Identifier: MIT
// The stages' names and numbers.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace stagelight {

// The folders of stages/ when CMake ran; stage 1 comes first.
const std::vector<std::string> &stage_names();

// "04_refraction_beer" for 4.
const std::string &stage_name(int number);

// The number that a stage's folder, or a scene named after it, begins with.
inline int stage_number(std::string_view name) {
    return (name[0] - '0') * 10 + (name[1] - '0');
}

}  // namespace stagelight
