// SPDX-License-Identifier: MIT
#include "scene/distance.h"

#include <algorithm>
#include <cstddef>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace stagelight {
namespace {

using glm::dot;
using glm::dvec3;

struct Segment {
    dvec3 start, along;
};

Segment edge(const TriangleCorners &triangle, std::size_t i) {
    return {triangle[i], triangle[(i + 1) % 3] - triangle[i]};
}

// Ericson, Real-Time Collision Detection (2005), section 5.1.9. Infinite where an end of one is the
// nearest point, which is told by closest_point.
double distance(const Segment &p, const Segment &q) {
    constexpr double none = std::numeric_limits<double>::infinity();
    const dvec3 r = p.start - q.start;
    const double a = dot(p.along, p.along), e = dot(q.along, q.along), b = dot(p.along, q.along);
    const double c = dot(p.along, r), f = dot(q.along, r);
    const double determinant = a * e - b * b;
    if (!(determinant > 0)) {  // they are parallel
        return none;
    }
    const double s = (b * f - c * e) / determinant, t = (a * f - b * c) / determinant;
    const bool is_within = s >= 0 && s <= 1 && t >= 0 && t <= 1;
    return is_within ? glm::length(r + s * p.along - t * q.along) : none;
}

// Whether the segment passes through the triangle: its ends lie on different sides, and its line
// within all three edges.
bool crosses(const Segment &segment, const TriangleCorners &triangle) {
    const dvec3 normal = glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
    const double from = dot(segment.start - triangle[0], normal);
    const double to = dot(segment.start + segment.along - triangle[0], normal);
    if ((from < 0) == (to < 0)) {
        return false;
    }
    int left = 0, right = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const double volume = dot(segment.along, glm::cross(triangle[i] - segment.start,
                                                            triangle[(i + 1) % 3] - segment.start));
        left += volume >= 0 ? 1 : 0;
        right += volume <= 0 ? 1 : 0;
    }
    return left == 3 || right == 3;
}

}  // namespace

// Ericson, section 5.1.5.
dvec3 closest_point(const TriangleCorners &triangle, const dvec3 &point) {
    const auto &[a, b, c] = triangle;
    const dvec3 ab = b - a, ac = c - a, ap = point - a, bp = point - b, cp = point - c;
    const double d1 = dot(ab, ap), d2 = dot(ac, ap);
    const double d3 = dot(ab, bp), d4 = dot(ac, bp);
    const double d5 = dot(ab, cp), d6 = dot(ac, cp);
    if (d1 <= 0 && d2 <= 0) {
        return a;
    }
    if (d3 >= 0 && d4 <= d3) {
        return b;
    }
    if (d6 >= 0 && d5 <= d6) {
        return c;
    }
    const double va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) {
        return a + d1 / (d1 - d3) * ab;
    }
    if (vb <= 0 && d2 >= 0 && d6 <= 0) {
        return a + d2 / (d2 - d6) * ac;
    }
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
        return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
    }
    return a + (vb * ab + vc * ac) / (va + vb + vc);
}

double distance(const TriangleCorners &a, const TriangleCorners &b) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 3; ++i) {
        if (crosses(edge(a, i), b) || crosses(edge(b, i), a)) {
            return 0;
        }
        nearest = std::min({nearest, glm::distance(a[i], closest_point(b, a[i])),
                            glm::distance(b[i], closest_point(a, b[i]))});
        for (std::size_t j = 0; j < 3; ++j) {
            nearest = std::min(nearest, distance(edge(a, i), edge(b, j)));
        }
    }
    return nearest;
}

}  // namespace stagelight
