// SPDX-License-Identifier: MIT
// How many rays a picture has taken.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "scene_types.h"

namespace stagelight {

// Summed over all samples of a picture.
struct RayTotals {
    std::uint64_t primary = 0;
    std::uint64_t shadow = 0;
    std::uint64_t reflection = 0;
    std::uint64_t refraction = 0;
    std::uint64_t dropped = 0;  // cut off by the depth limit
    std::uint64_t cut_off = 0;  // too weak to be traced
    double cut_off_weight = 0;  // the largest sum of their weights in one sample of a pixel

    RayTotals &operator+=(const RayTotals &more);
    std::uint64_t traced() const { return primary + shadow + reflection + refraction; }
    // Million rays a second, of a picture that took so long.
    double rate(double milliseconds) const {
        return static_cast<double>(traced()) / milliseconds / 1000;
    }
};

// The rows' sum, and a primary ray for each of `pixels`.
RayTotals totals_of(const std::vector<device::RayCounts> &rows, std::size_t pixels);

}  // namespace stagelight
