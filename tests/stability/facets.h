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

inline SceneNeeds with_maps(int width) {
    return {{"WIDTH", width}, {"HAS_TRIANGLES", 1}, {"HAS_TREE", 1}, {"BVH_WIDTH", 4}, {"HAS_FACET_MAPS", 1}};
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

// What takes corner + b * to_b + c * to_c + height * (the normal's longest axis) back to b, c and
// the height, rounded once.
inline device::FacetMap map_of(const device::Facet &facet) {
    const glm::dvec3 a(corner(facet, 0));
    const glm::dvec3 to_b = glm::dvec3(corner(facet, 1)) - a;
    const glm::dvec3 to_c = glm::dvec3(corner(facet, 2)) - a;
    const glm::dvec3 slope = glm::abs(glm::cross(to_b, to_c));
    device::FacetMap map = {};
    map.axis = slope.x > slope.y ? (slope.x > slope.z ? 0 : 2) : (slope.y > slope.z ? 1 : 2);
    glm::dvec3 up(0);
    up[map.axis] = 1;
    const glm::dmat3 back = glm::transpose(glm::inverse(glm::dmat3(to_b, to_c, up)));
    for (int row = 0; row < 3; ++row) {
        float *out = row == 0 ? map.to_b : row == 1 ? map.to_c : map.along;
        out[0] = float(back[row][(map.axis + 1) % 3]);
        out[1] = float(back[row][(map.axis + 2) % 3]);
        out[2] = float(-glm::dot(back[row], a));
    }
    return map;
}

// Scaled, then moved, then rounded.
inline Corners placed(Corners corners, double scale, const glm::dvec3 &at) {
    for (glm::dvec3 &corner : corners) {
        corner = glm::dvec3(glm::vec3(at + scale * corner));
    }
    return corners;
}

}  // namespace stagelight::stability
