// SPDX-License-Identifier: MIT
// Rays and lines against spheres, planes and triangles (paper, section 2: "for every
// shape type we have defined an intersection function with both rays and lines").
// The ways are chosen for precision, and to be others than the kernels'.
#pragma once

#include <optional>

#include "reference/rays.h"

namespace stagelight::reference {

// The smallest distance t > 0 at which the ray meets the sphere, from inside too.
// t² − 2bt + c = 0 with the root of the larger magnitude first and the other as c / it
// (Press et al., Numerical Recipes, section 5.6), and the discriminant from the vector
// that is perpendicular to the ray (Haines et al., Ray Tracing Gems, 2019, chapter 7):
// neither b² − c nor a difference of like distances loses digits far from the sphere.
template <typename Number>
std::optional<Number> intersect_sphere(const Ray<Number> &ray, const Vec<Number> &center,
                                       Number radius) {
    const Vec<Number> to_center = center - ray.origin;
    const Number b = glm::dot(to_center, ray.direction);
    const Number perpendicular = glm::length(to_center - b * ray.direction);
    if (perpendicular > radius)
        return std::nullopt;
    const Number half_chord = std::sqrt((radius - perpendicular) * (radius + perpendicular));
    const Number distance = glm::length(to_center);
    const Number c = (distance - radius) * (distance + radius);
    const Number outer = b < 0 ? b - half_chord : b + half_chord;
    const Number inner = c / outer;
    const Number nearest =
        std::min(inner, outer) > 0 ? std::min(inner, outer) : std::max(inner, outer);
    return nearest > 0 ? std::optional(nearest) : std::nullopt;
}

// The distance t > 0 at which the ray meets the plane; none when it runs along it.
template <typename Number>
std::optional<Number> intersect_plane(const Ray<Number> &ray, const Vec<Number> &normal,
                                      const Vec<Number> &point) {
    const Number approach = glm::dot(ray.direction, normal);
    if (approach == 0)
        return std::nullopt;
    const Number distance = glm::dot(point - ray.origin, normal) / approach;
    return distance > 0 ? std::optional(distance) : std::nullopt;
}

// The corners of a triangle.
template <typename Number> struct Corners { Vec<Number> a, b, c; };

// A triangle's normal, of the length of twice its area.
template <typename Number> Vec<Number> facing(const Corners<Number> &corners) {
    return glm::cross(corners.b - corners.a, corners.c - corners.a);
}

template <typename Number> struct TriangleHit {
    Number distance;
    Number u, v;  // barycentric coordinates of b and c
};

// The volumes (times six) of the tetrahedra that `direction` spans with each edge, seen from
// the origin of the corners: that of b c, of c a, of a b. They are of one sign when the
// direction passes through the triangle, and are its barycentric coordinates times their
// sum. An edge that two triangles share gets the same number in both, so no ray passes
// between them (Kensler and Shirley, Optimizing Ray-Triangle Intersection via Automated
// Search, 2006).
template <typename Number>
Vec<Number> edge_volumes(const Corners<Number> &corners, const Vec<Number> &direction) {
    return {glm::dot(direction, glm::cross(corners.b, corners.c)),
            glm::dot(direction, glm::cross(corners.c, corners.a)),
            glm::dot(direction, glm::cross(corners.a, corners.b))};
}

// Zero belongs to both signs: edges and corners are part of the triangle.
template <typename Number> bool of_one_sign(const Vec<Number> &v) {
    return (v.x >= 0 && v.y >= 0 && v.z >= 0) || (v.x <= 0 && v.y <= 0 && v.z <= 0);
}

template <typename Number>
Corners<Number> seen_from(const Vec<Number> &origin, const Corners<Number> &corners) {
    return {corners.a - origin, corners.b - origin, corners.c - origin};
}

// The distance t > 0 and where; none when the ray runs in the triangle's plane.
template <typename Number>
std::optional<TriangleHit<Number>> intersect_triangle(const Ray<Number> &ray,
                                                      const Corners<Number> &corners) {
    const Corners<Number> seen = seen_from(ray.origin, corners);
    const Vec<Number> volumes = edge_volumes(seen, ray.direction);
    const Number sum = volumes.x + volumes.y + volumes.z;
    if (!of_one_sign(volumes) || sum == 0)
        return std::nullopt;
    const Vec<Number> weights = volumes / sum;
    const Number distance = glm::dot(weights, Vec<Number>(glm::dot(seen.a, ray.direction),
                                                          glm::dot(seen.b, ray.direction),
                                                          glm::dot(seen.c, ray.direction)));
    if (!(distance > 0))
        return std::nullopt;
    return TriangleHit<Number>{distance, weights.y, weights.z};
}

// A line meets a sphere when one end is inside and the other is not, or when both are outside
// and the point between them that is nearest to the centre is inside.
template <typename Number>
bool line_meets_sphere(const Line<Number> &line, const Vec<Number> &center, Number radius) {
    const bool from_inside = glm::distance(line.origin, center) < radius;
    const bool to_inside = glm::distance(line.destination, center) < radius;
    if (from_inside || to_inside)
        return from_inside != to_inside;
    const Vec<Number> along = line.destination - line.origin;
    const Number nearest =
        glm::dot(center - line.origin, along) / glm::dot(along, along);  // 0 origin, 1 destination
    return nearest > 0 && nearest < 1
           && glm::distance(line.origin + nearest * along, center) <= radius;
}

// A line meets a plane when its ends lie on different sides.
template <typename Number>
bool line_meets_plane(const Line<Number> &line, const Vec<Number> &normal,
                      const Vec<Number> &point) {
    const Number from = glm::dot(line.origin - point, normal);
    const Number to = glm::dot(line.destination - point, normal);
    return (from < 0 && to > 0) || (from > 0 && to < 0);
}

// The same for the triangle's plane, and the line passes within its edges.
template <typename Number>
bool line_meets_triangle(const Line<Number> &line, const Corners<Number> &corners) {
    return line_meets_plane(line, facing(corners), corners.a)
           && of_one_sign(
               edge_volumes(seen_from(line.origin, corners), line.destination - line.origin));
}

}  // namespace stagelight::reference
