// SPDX-License-Identifier: MIT
// Triangles as tests/kernels/facets.cl has them.
#pragma once

#include <array>

#include <glm/glm.hpp>

#include "device/scene_needs.h"
#include "scene_types.h"

namespace stagelight::stability {

using Exact = glm::vec<3, long double>;
using Corners = std::array<glm::dvec3, 3>;

inline SceneNeeds with_facets(int width) {
    return {{"WIDTH", width}, {"HAS_TRIANGLES", 1}, {"HAS_TREE", 1}};
}

inline device::Facet facet_of(const Corners &corners) {
    device::Facet facet = {};
    for (std::size_t i = 0; i < 3; ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            facet.corners[i][axis] = float(corners[i][axis]);
        }
    }
    return facet;
}

inline Exact corner(const device::Facet &facet, std::size_t i) {
    return {facet.corners[i][0], facet.corners[i][1], facet.corners[i][2]};
}

// Scaled, then moved, then rounded.
inline Corners placed(Corners corners, double scale, const glm::dvec3 &at) {
    for (glm::dvec3 &corner : corners) {
        corner = glm::dvec3(glm::vec3(at + scale * corner));
    }
    return corners;
}

}  // namespace stagelight::stability
