// SPDX-License-Identifier: MIT
// Introduced by stage 02: where a ray starts that leaves a surface. Rounding has moved the hit point, and
// a ray from the wrong side of the surface would hit what it leaves.
#include "ray.cl"
#include "origin/error_bound.cl"

// #region rounding
// What `count` roundings in a row do to a number, at the most (section 3.9.1 there). A division counts as
// five and a square root as six: OpenCL 1.2 promises 2.5 and 3 ulp, of two roundings each, where a device
// does not round them as IEEE 754 has it (specification, section 7.4).
#if METHOD_MATH_FP64
#define ROUNDING 1.1102230246251565e-16
#else
#define ROUNDING 5.9604645e-8f
#endif
#define GAMMA(count) (ROUNDING * (count) / (1.0f - ROUNDING * (count)))

// #region error_along
// Of a position that is off by up to `error` along each axis, itself to be rounded once more: how far off
// along the normal, of any length.
static float error_along(const float3 normal, const float3 position, const float3 error) {
    const float3 moved = error + GAMMA(2.0f) * fabs(position);
    return dot(fabs(normal), moved) * rsqrt(dot(normal, normal));
}
// #endregion error_along
// #endregion rounding

// #region offset_ray_origin
// To the side of the surface that `direction`, of any length, points to.
static float3 offset_ray_origin(const Surface *surface, const float3 direction) {
    const float side = dot(surface->geometric_normal, direction) < 0.0f ? -1.0f : 1.0f;
    return offset_along(surface->position, side * surface->geometric_normal, surface->ray_offset);
}
// #endregion offset_ray_origin
