// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

namespace stagelight {

// A line down a picture that divides it in two: the columns in [begin, end) are the line's, those
// before are left of it, those after right.
struct SplitLine {
    int begin;
    int end;
};

constexpr double split_share = 0.5;    // where --split has its line
constexpr float split_line_value = 1;  // of all its channels, as the screen shows them

// `share`, in [0, 1], of a picture of `width` columns, > 0, is left of the line.
inline SplitLine split_line(double share, int width) {
    constexpr int pictures_per_line = 320;
    const int thickness = std::max(1, width / pictures_per_line);
    const int begin = static_cast<int>(std::lround(share * (width - thickness)));
    return {begin, begin + thickness};
}

}  // namespace stagelight
