// SPDX-License-Identifier: MIT
// Introduced by stage 02: where a ray starts that leaves a surface. Rounding has moved the hit point, and
// a ray from the wrong side of the surface would hit what it leaves.
#include "ray.cl"

// #region leave
// From a position on the surface to the side of `normal`, which is of unit length. Best for scenes of any
// size is `scaled`; tests/stability shows where each other fails.
#ifndef METHOD_ORIGIN
#define METHOD_ORIGIN scaled
#endif
#define leave JOIN(leave_, METHOD_ORIGIN)
// #endregion leave

// #region leave_fixed
// The habit: a distance that suits scenes some units wide, and no others.
#define FIXED_OFFSET 1e-3f

static float3 leave_fixed(const Surface *surface, const float3 position, const float3 normal) {
    return position + FIXED_OFFSET * normal;
}
// #endregion leave_fixed

// #region leave_scaled
// Rounding moves a hit point by a few units in the last place of the largest number that went into it:
// some thirty such units are enough.
#define SCALED_OFFSET 2e-6f

static float3 leave_scaled(const Surface *surface, const float3 position, const float3 normal) {
    return position + SCALED_OFFSET * surface->reach * normal;
}
// #endregion leave_scaled

// #region leave_integer
// In units of the last place of each coordinate, by counting its bits as an integer; near 0, where those
// units shrink to nothing, a fixed distance (Wächter and Binder, A Fast and Robust Method for Avoiding
// Self-Intersection, Ray Tracing Gems, 2019, chapter 6).
#define INTEGER_STEPS 256.0f
#define NEAR_ZERO (1.0f / 32.0f)
#define NEAR_ZERO_OFFSET (1.0f / 65536.0f)

static float3 leave_integer(const Surface *surface, const float3 position, const float3 normal) {
    const int3 steps = convert_int3(INTEGER_STEPS * normal);
    const float3 moved = as_float3(as_int3(position) + (position < 0.0f ? -steps : steps));
    return fabs(position) < NEAR_ZERO ? position + NEAR_ZERO_OFFSET * normal : moved;
}
// #endregion leave_integer

// #region leave_error_bound
// By no more than rounding can have moved the position along the normal, and then to the next number
// (Pharr, Jakob and Humphreys, Physically Based Rendering, 3rd edition, section 3.9.5).
#if HAS_ORIGIN_ERROR
static float3 leave_error_bound(const Surface *surface, const float3 position,
                                const float3 normal) {
    const float3 offset = dot(fabs(normal), surface->error) * normal;
    const float3 away = offset > 0.0f ? (float3)(INFINITY) : (float3)(-INFINITY);
    const float3 moved = position + offset;
    return offset == 0.0f ? moved : nextafter(moved, away);
}
#endif
// #endregion leave_error_bound

// #region origin_off
// To the side of the surface that `direction`, of any length, points to.
static float3 origin_off(const Surface *surface, const float3 direction) {
    const float side = dot(surface->geometric_normal, direction) < 0.0f ? -1.0f : 1.0f;
    return leave(surface, surface->position, side * surface->geometric_normal);
}

// What leave_scaled measures by.
static float reach_of(const Ray ray, const float distance) {
    const float3 size = fabs(ray.origin);
    return max(size.x, max(size.y, size.z)) + distance;
}
// #endregion origin_off
