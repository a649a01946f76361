// SPDX-License-Identifier: MIT
// What a run has cost, as JSON.
#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "app/run.h"

namespace stagelight {

// Its name, platform, versions and compute units.
nlohmann::ordered_json device_json(const cl::Device &device);
// By kind.
nlohmann::ordered_json rays_json(const RayTotals &rays);
// By argument, and their total.
nlohmann::ordered_json bytes_json(const std::map<std::string, std::size_t> &sizes);

// Says on stdout which device has drawn and what that cost, and with --verbose where the time went,
// what was cut off and what the kernel leaves out; writes the stats if --stats names a file.
void report(const Run &run, const RunResult &result);

// Of the time in which frames were presented, the share in which the next was being rendered.
double overlap_of(const std::vector<FrameTimes> &frames);

// The middle one; the mean of the middle two.
double median(std::vector<double> values);

// That of what `figure` says of each element.
double median_of(const auto &elements, const auto &figure) {
    std::vector<double> values(elements.size());
    std::ranges::transform(elements, values.begin(), figure);
    return median(std::move(values));
}

}  // namespace stagelight
