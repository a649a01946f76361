// SPDX-License-Identifier: MIT
// Where rays meet a sphere.
#include "packets/wide.cl"

// #region wide_ray_sphere_textbook
// t * t + b * t + c = 0, by the formula of school. Far away b * b and 4 * c are nearly one and the same,
// and what is left is noise.
static Wide wide_ray_sphere(const WideRays *rays, const float3 center, const float radius) {
    const Wide3 from_center = wide_difference(rays->origin, wide3(center));
    const Wide b = 2.0f * wide_dot(from_center, rays->direction);
    const Wide c = wide_dot(from_center, from_center) - radius * radius;
    const Wide root = sqrt(b * b - 4.0f * c);
    const Wide distance = 0.5f * (c < 0.0f ? -b + root : -b - root);
    return distance > 0.0f ? distance : (Wide)(INFINITY);
}
// #endregion wide_ray_sphere_textbook
