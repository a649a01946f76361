// SPDX-License-Identifier: MIT
// How far points and triangles are from each other.
#pragma once

#include <array>

#include <glm/vec3.hpp>

namespace stagelight {

using TriangleCorners = std::array<glm::dvec3, 3>;

glm::dvec3 closest_point(const TriangleCorners &triangle, const glm::dvec3 &point);

// 0 where they cross.
double distance(const TriangleCorners &a, const TriangleCorners &b);

}  // namespace stagelight
