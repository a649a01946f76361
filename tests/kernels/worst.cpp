// SPDX-License-Identifier: MIT
#include "kernels/worst.h"

#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace stagelight {

void Worst::compare(std::size_t index, double is, double expected, double tolerance) {
    // Two infinities have no difference that is a number.
    const double error = is == expected ? 0 : std::abs(is - expected);
    note(error, tolerance,
         fmt::format("case {} is {}, expected {} within {:.2g}", index, is, expected, tolerance));
}

void Worst::compare(std::size_t index, const glm::dvec3 &is, const glm::dvec3 &expected,
                    double tolerance) {
    note(glm::distance(is, expected), tolerance,
         fmt::format("case {} is ({}, {}, {}), expected ({}, {}, {}) within {:.2g}", index, is.x,
                     is.y, is.z, expected.x, expected.y, expected.z, tolerance));
}

void Worst::note(double error, double tolerance, const std::string &text) {
    ++compared_;
    const double ratio = error == 0 ? 0 : error / tolerance;
    if (!(ratio <= 1)) {
        ++outside_;
    }
    if (!(ratio <= worst_ratio_)) {
        worst_ratio_ = std::isnan(ratio) ? std::numeric_limits<double>::infinity() : ratio;
        worst_ = text;
    }
}

void Worst::expect(std::size_t least) const {
    EXPECT_GE(compared_, least) << what_ << ": too few cases could be compared";
    EXPECT_EQ(outside_, 0u) << what_ << ": of " << compared_ << " comparisons the worst, "
                            << worst_ratio_ << " times its tolerance: " << worst_;
}

}  // namespace stagelight
