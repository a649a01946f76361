// SPDX-License-Identifier: MIT
// The curves between light and a picture's values in double, for values in [0, 1].
#pragma once

#include <cmath>

namespace stagelight::exact {

// IEC 61966-2-1.
inline double srgb_encode(double light) {
    return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
}

inline double srgb_decode(double value) {
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

// The paper, section 8.
inline double power_encode(double light) {
    return std::pow(light, 1 / 2.2);
}

inline double power_decode(double value) {
    return std::pow(value, 2.2);
}

}  // namespace stagelight::exact
