// SPDX-License-Identifier: MIT
// Core exercise 02 line: whether a sphere is between a surface and a lamp.

// kernels/sphere.cl
// #region line_sphere
// Whether the line crosses the sphere's surface.
static bool intersect_line_sphere(const Line line, const float3 center, const float radius) {
    return false;  // your turn
}
// #endregion line_sphere
