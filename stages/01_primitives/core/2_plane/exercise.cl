// SPDX-License-Identifier: MIT
// Core exercise 01 plane: where a ray meets a plane.

// kernels/plane.cl
// #region ray_plane
// The distance along the ray, INFINITY where it misses dot(normal, p) = offset.
static float intersect_ray_plane(const Ray ray, const float3 normal, const float offset) {
    return INFINITY;  // your turn
}
// #endregion ray_plane
