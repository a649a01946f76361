// SPDX-License-Identifier: MIT
// What a number in a scene file may be: the words for a message, and the check.
#pragma once

#include <cmath>
#include <string_view>

#include "scene/scene_file.h"

namespace stagelight {

// Asked only of a number that is finite and at most largest_number in magnitude, as all must be.
struct Validator {
    std::string_view words;
    bool (*holds)(double);
};

// Its square is still a finite float.
constexpr double largest_number = 1e18;

constexpr Validator any_number{"a number", [](double) { return true; }};
constexpr Validator positive{"a number above 0", [](double v) { return v > 0; }};
constexpr Validator not_negative{"a number of 0 or more", [](double v) { return v >= 0; }};
constexpr Validator not_zero{"a number other than 0", [](double v) { return v != 0; }};
constexpr Validator share{"a number from 0 to 1", [](double v) { return v >= 0 && v <= 1; }};
constexpr Validator field_of_view{"an angle above 0 and below 180 degrees",
                                  [](double v) { return v > 0 && v < 180; }};
constexpr Validator bounces{"a whole number from 0 to 64",
                            [](double v) { return v == std::floor(v) && v >= 0 && v <= 64; }};
constexpr Validator rank{"a whole number from -1000000 to 1000000",
                         [](double v) { return v == std::floor(v) && v >= -1e6 && v <= 1e6; }};
static_assert(largest_image_size == 16384, "the words of `pixels` say so");
constexpr Validator pixels{"a whole number from 1 to 16384", [](double v) {
                               return v == std::floor(v) && v >= 1 && v <= largest_image_size;
                           }};

}  // namespace stagelight
