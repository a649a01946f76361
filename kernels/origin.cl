// SPDX-License-Identifier: MIT
// Introduced by stage 02: where a ray starts that leaves a surface. Rounding has moved the hit point, and
// a ray from the wrong side of the surface would hit what it leaves.
#include "ray.cl"

// #region leave
// From a position on the surface to the side of `normal`, which is of unit length. tests/stability shows
// where each fails.
#ifndef METHOD_ORIGIN
#define METHOD_ORIGIN error_bound
#endif
#define leave JOIN(leave_, METHOD_ORIGIN)
// #endregion leave

// #region leave_error_bound
// #region add_offset
// By no more than rounding can have moved the position along the normal, and can move where the next ray
// meets the same shape (after Pharr, Jakob and Humphreys, Physically Based Rendering, 3rd edition, section
// 3.9): `offset` is that bound, which each shape works out from its own numbers.
static float3 leave_error_bound(const float3 position, const float3 normal, const float offset) {
    return position + offset * normal;
}
// #endregion add_offset

// What `count` roundings in a row do to a number, at the most (section 3.9.1 there). A division counts as
// five and a square root as six: OpenCL 1.2 promises 2.5 and 3 ulp, of two roundings each, where a device
// does not round them as IEEE 754 has it (specification, section 7.4). The maps of Baldwin and Weber were
// rounded to float on the host.
#if METHOD_MATH_FP64 && !HAS_FACET_MAPS
#define ROUNDING 1.1102230246251565e-16
#else
#define ROUNDING 5.9604645e-8f
#endif
#define GAMMA(count) ((count) * ROUNDING / (1.0f - (count) * ROUNDING))

// #region error_along
// Of a position that is off by up to `error` along each axis, itself to be rounded once more: how far off
// along the normal, of any length.
static float error_along(const float3 normal, const float3 position, const float3 error) {
    const float3 moved = error + GAMMA(2.0f) * fabs(position);
    return dot(fabs(normal), moved) * rsqrt(dot(normal, normal));
}
// #endregion error_along
// #endregion leave_error_bound

// #region leave_scaled
// By some thirty units in the last place of the largest number that went into the hit point.
#define SCALED_OFFSET 2e-6f

static float3 leave_scaled(const float3 position, const float3 normal, const float offset) {
    return position + offset * normal;
}

static float scaled_offset(const Ray ray, const float distance) {
    const float3 size = fabs(ray.origin);
    return SCALED_OFFSET * (max(size.x, max(size.y, size.z)) + distance);
}
// #endregion leave_scaled

// #region leave_fixed
// The habit: a distance that suits scenes some units wide, and no others.
#define FIXED_OFFSET 1e-3f

static float3 leave_fixed(const float3 position, const float3 normal, const float offset) {
    return position + FIXED_OFFSET * normal;
}
// #endregion leave_fixed

// #region leave_integer
// In units of the last place of each coordinate, by counting its bits as an integer; near 0, where those
// units shrink to nothing, a fixed distance (Wächter and Binder, A Fast and Robust Method for Avoiding
// Self-Intersection, Ray Tracing Gems, 2019, chapter 6).
#define INTEGER_STEPS 256.0f
#define NEAR_ZERO (1.0f / 32.0f)
#define NEAR_ZERO_OFFSET (1.0f / 65536.0f)

static float3 leave_integer(const float3 position, const float3 normal, const float offset) {
    const JOIN(LANE_INT, 3) steps = JOIN(TO_LANE_INT, 3)(INTEGER_STEPS * normal);
    const float3 moved = JOIN(AS_REAL, 3)(JOIN(AS_LANE_INT, 3)(position)
                                          + (position < 0.0f ? -steps : steps));
    return fabs(position) < NEAR_ZERO ? position + NEAR_ZERO_OFFSET * normal : moved;
}
// #endregion leave_integer

// #region origin_off
// To the side of the surface that `direction`, of any length, points to.
static float3 origin_off(const Surface *surface, const float3 direction) {
    const float side = dot(surface->geometric_normal, direction) < 0.0f ? -1.0f : 1.0f;
    return leave(surface->position, side * surface->geometric_normal, surface->offset);
}
// #endregion origin_off
