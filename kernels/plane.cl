// SPDX-License-Identifier: MIT
// Introduced by stage 01; extended by 02 (lines): where rays and lines meet a plane.
#include "ray.cl"

// #region ray_plane
// dot(normal, origin + t * direction) = offset, solved for t. A ray in the plane misses it:
// both differences are zero, and their quotient, a NaN, is not above zero.
static float intersect_ray_plane(const Ray ray, const float3 normal, const float offset) {
    const float t = (offset - dot(normal, ray.origin)) / dot(normal, ray.direction);
    return t > 0.0f ? t : INFINITY;
}
// #endregion ray_plane

// #region line_plane
// A line crosses when its ends lie on different sides, neither of them in the plane: no
// division, and no product of two numbers that may be tiny.
static bool intersect_line_plane(const Line line, const float3 normal, const float offset) {
    const float before = dot(normal, line.origin) - offset;
    const float after = dot(normal, line.destination) - offset;
    return (before < 0.0f && after > 0.0f) || (before > 0.0f && after < 0.0f);
}
// #endregion line_plane
