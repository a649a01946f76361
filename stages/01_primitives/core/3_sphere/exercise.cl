// SPDX-License-Identifier: MIT
// Core exercise 01 sphere: where a ray meets a sphere.

// kernels/sphere/geometric.cl
// #region ray_sphere
// The distance along the ray to the first wall ahead, INFINITY where it misses.
static float intersect_ray_sphere(const Ray ray, const float3 center, const float radius) {
    return INFINITY;  // your turn
}
// #endregion ray_sphere
