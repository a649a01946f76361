// SPDX-License-Identifier: MIT
// What a run has cost, as JSON.
#pragma once

#include <string>
#include <vector>

#include "device/renderer.h"

namespace stagelight {

// Device, driver, build options, milliseconds, rays by kind, dropped rays, bytes on the device
// and what the scene needed. `frames` has the milliseconds of each frame, `last` the last one.
std::string stats_json(const std::string &stage, const Renderer &renderer,
                       const RenderSettings &settings, const std::vector<double> &frames,
                       const Frame &last);

// The middle one; the mean of the middle two.
double median(std::vector<double> values);

}  // namespace stagelight
