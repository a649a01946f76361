// SPDX-License-Identifier: MIT
// Introduced by stage 08: the curves between light and the values of a picture file or a screen.
// This file is compiled as C++, as OpenCL C and as GLSL.
#ifndef STAGELIGHT_TRANSFER_CURVES_H
#define STAGELIGHT_TRANSFER_CURVES_H

#if defined(__cplusplus)
#include <array>
#include <cmath>
#define TRANSFER inline
namespace stagelight::transfer {
using std::floor;
using std::pow;
#elif defined(__OPENCL_VERSION__)
#define TRANSFER static
#else
#define TRANSFER
#endif

// #region within
// What a screen can show of a value: not a number and negatives as 0, what is above 1 as 1.
TRANSFER float within_screen(float value) {
    return value > 0.0f ? (value < 1.0f ? value : 1.0f) : 0.0f;
}
// #endregion within

// #region srgb
// IEC 61966-2-1: a straight line in the dark, where a power alone would be infinitely steep.
TRANSFER float srgb_encode(float light) {
    float l = within_screen(light);
    return l <= 0.0031308f ? 12.92f * l : 1.055f * pow(l, 1.0f / 2.4f) - 0.055f;
}

TRANSFER float srgb_decode(float value) {
    float v = within_screen(value);
    return v <= 0.04045f ? v / 12.92f : pow((v + 0.055f) / 1.055f, 2.4f);
}
// #endregion srgb

// #region power
// The paper's approximation (section 8): one power for all.
TRANSFER float power_encode(float light) {
    return pow(within_screen(light), 1.0f / 2.2f);
}

TRANSFER float power_decode(float value) {
    return pow(within_screen(value), 2.2f);
}
// #endregion power

#if defined(__cplusplus) || defined(HAS_SRGB_TABLE)
// #region table
// The sRGB curve by straight lines between points of it, with no power to work out: off by less
// than half a code, most in the dark. In GLSL `srgb_table` comes before this text
// (srgb_table_in_glsl).
#if defined(__cplusplus)
inline const std::array<float, 257> srgb_table = [] {
    std::array<float, 257> table{};
    for (std::size_t i = 0; i < table.size(); ++i) {
        table[i] = srgb_encode(static_cast<float>(i) / 256);
    }
    return table;
}();
#define TABLE_INDEX(at) static_cast<std::size_t>(at)
#else
#define TABLE_INDEX(at) int(at)
#endif

TRANSFER float table_encode(float light) {
    float at = 256.0f * within_screen(light);
    float below = at < 255.0f ? floor(at) : 255.0f;
    float low = srgb_table[TABLE_INDEX(below)];
    return low + (at - below) * (srgb_table[TABLE_INDEX(below + 1.0f)] - low);
}
// #endregion table
#endif

#undef TRANSFER
#if defined(__cplusplus)
}  // namespace stagelight::transfer
#endif

#endif
