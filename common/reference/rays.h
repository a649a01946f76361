// SPDX-License-Identifier: MIT
// Rays and lines: the words of the paper's section 2.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace stagelight::reference {

template <typename Number> using Vec = glm::vec<3, Number>;
template <typename Number> using Vec2 = glm::vec<2, Number>;

// An origin, a direction of unit length, no end.
template <typename Number> struct Ray {
    Vec<Number> origin;
    Vec<Number> direction;
};

// An origin and a destination: what lies beyond does not matter.
template <typename Number> struct Line {
    Vec<Number> origin;
    Vec<Number> destination;
};

template <typename Number> Ray<Number> ray_along(const Line<Number> &line) {
    return {line.origin, glm::normalize(line.destination - line.origin)};
}

template <typename Number> Number largest(const Vec<Number> &v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

// How far off a surface its rays start: far above the rounding of a point whose largest
// coordinate is `size`, and in float still below the 2e-5 of docs/shading.md.
template <typename Number> Number surface_offset(Number size) {
    return 128 * std::numeric_limits<Number>::epsilon() * size;
}

// A surface with the normal `normal` is left to the side that `direction` goes to.
template <typename Number>
Ray<Number> ray_off_surface(const Vec<Number> &point, const Vec<Number> &normal,
                            const Vec<Number> &direction, Number offset) {
    const Number side = glm::dot(direction, normal) < 0 ? -offset : offset;
    return {point + side * normal, direction};
}

}  // namespace stagelight::reference
