// SPDX-License-Identifier: MIT
// Where rays meet a sphere.
#include "ray.cl"

// #region ray_sphere
// t * t + b * t + c = 0, by the formula of school. Far away b * b and 4 * c are nearly one and the same,
// and what is left is noise.
static float intersect_ray_sphere(const Ray ray, const float3 center, const float radius) {
    const float3 from_center = ray.origin - center;
    const float b = 2.0f * dot(from_center, ray.direction);
    const float c = dot(from_center, from_center) - radius * radius;
    const float root = sqrt(b * b - 4.0f * c);
    const float distance = 0.5f * (c < 0.0f ? -b + root : -b - root);
    return distance > 0.0f ? distance : INFINITY;
}
// #endregion ray_sphere
