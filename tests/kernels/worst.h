// SPDX-License-Identifier: MIT
// Thousands of comparisons in one test: a failure tells the worst of them.
#pragma once

#include <cstddef>
#include <limits>
#include <string>

#include <glm/vec3.hpp>

namespace stagelight {

// The distance from 1 to the next float: tolerances are counted in it.
constexpr double ulp = std::numeric_limits<float>::epsilon();

class Worst {
public:
    explicit Worst(std::string what) : what_(std::move(what)) {}

    // `index` is the case's. A NaN is worse than all else.
    void compare(std::size_t index, double is, double expected, double tolerance);
    void compare(std::size_t index, const glm::dvec3 &is, const glm::dvec3 &expected,
                 double tolerance);

    // Fails unless at least `least` comparisons were made (ties were left out, but most cases
    // are none), all within their tolerances.
    void expect(std::size_t least) const;

private:
    void note(double error, double tolerance, const std::string &text);

    std::string what_;
    std::string worst_ = "none";
    double worst_ratio_ = -1;  // error over tolerance
    std::size_t compared_ = 0;
    std::size_t outside_ = 0;
};

}  // namespace stagelight
