// SPDX-License-Identifier: MIT
// The pinhole camera (docs/shading.md, "The camera").
#pragma once

#include <numbers>

#include "reference/rays.h"
#include "scene/scene.h"

namespace stagelight::reference {

// The ray through the point (x, y) of a picture of width by height pixels, counted in
// pixels from its upper left corner.
template <typename Number>
Ray<Number> primary_ray(const CameraDescription &camera, int width, int height, Number x,
                        Number y) {
    const Vec<Number> position(camera.position);
    const Vec<Number> forward = glm::normalize(Vec<Number>(camera.look_at) - position);
    const Vec<Number> right = glm::normalize(glm::cross(forward, Vec<Number>(camera.up)));
    const Vec<Number> true_up = glm::cross(right, forward);
    const Number half_width =
        std::tan(Number(camera.fov) * std::numbers::pi_v<Number> / Number(360));
    const Number half_height = half_width * Number(height) / Number(width);
    return {position, glm::normalize(forward + half_width * (2 * x / Number(width) - 1) * right
                                     + half_height * (1 - 2 * y / Number(height)) * true_up)};
}

}  // namespace stagelight::reference
