// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include <glm/trigonometric.hpp>

#include "scene/rounding.h"
#include "scene/scene.h"

namespace stagelight {

// How far surfaces that touch are moved apart: 64 roundings, four times of what counts as touching,
// but no more than a fiftieth of a pixel. `scale` is what float_rounding is a share of, `nearest`
// the least distance from the camera at which it sees what is moved.
inline double contact_margin(const Scene &scene, double scale, double nearest) {
    const double pixel = 2 * std::tan(glm::radians(scene.camera.fov / 2)) / scene.width;
    return std::min(64 * float_rounding * scale, nearest * pixel / 50);
}

}  // namespace stagelight
