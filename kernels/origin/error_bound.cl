// SPDX-License-Identifier: MIT
// Introduced by stage 02: off a surface, to the side of `normal`, which is of unit length.
// tests/stability shows where this and the other ways fail.
#include "ray.cl"

// #region add_offset
// By no more than rounding can have moved the position along the normal, and can move where the next ray
// meets the same shape (after Pharr, Jakob and Humphreys, Physically Based Rendering, 3rd edition, section
// 3.9): `ray_offset` is that bound, which each shape works out from its own numbers.
static float3 offset_along(const float3 position, const float3 normal, const float ray_offset) {
    return position + ray_offset * normal;
}
// #endregion add_offset

// How far off the surface that is, where a ray has met it at a distance; `bound` is its shape's.
static float ray_offset(const Ray ray, const float distance, const float bound) {
    return bound;
}
