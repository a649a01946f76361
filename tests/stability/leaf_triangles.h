// SPDX-License-Identifier: MIT
// Triangles as tests/kernels/leaf_triangles.cl has them.
#pragma once

#include <array>

#include <glm/glm.hpp>

#include "device/scene_needs.h"
#include "scene_types.h"

namespace stagelight::stability {

using Exact = glm::vec<3, long double>;
using Corners = std::array<glm::dvec3, 3>;

inline SceneNeeds with_triangles(int width) {
    return {{"WIDTH", width}, {"HAS_TRIANGLES", 1}, {"HAS_TREE", 1}};
}

using DeviceCorners = std::array<device::float4, 3>;

inline DeviceCorners to_device(const Corners &corners) {
    DeviceCorners device = {};
    for (std::size_t i = 0; i < 3; ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            device[i].s[axis] = float(corners[i][axis]);
        }
    }
    return device;
}

inline Exact corner(const DeviceCorners &corners, std::size_t i) {
    return {corners[i].s[0], corners[i].s[1], corners[i].s[2]};
}

// Scaled, then moved, then rounded.
inline Corners placed(Corners corners, double scale, const glm::dvec3 &at) {
    for (glm::dvec3 &corner : corners) {
        corner = glm::dvec3(glm::vec3(at + scale * corner));
    }
    return corners;
}

}  // namespace stagelight::stability
