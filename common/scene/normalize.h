// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace stagelight {

// `vector`, which is not zero, at length 1. Scaled first: the squares of tiny
// components would vanish.
inline glm::dvec3 normalize(const glm::dvec3 &vector) {
    const double largest = std::max({std::abs(vector.x), std::abs(vector.y), std::abs(vector.z)});
    const glm::dvec3 scaled = vector / largest;
    return scaled / glm::length(scaled);
}

}  // namespace stagelight
