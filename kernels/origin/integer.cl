// SPDX-License-Identifier: MIT
// Off a surface in units of the last place of each coordinate, by counting its bits as an integer; near 0, where
// those units shrink to nothing, a fixed distance (Wächter and Binder, A Fast and Robust Method for Avoiding
// Self-Intersection, Ray Tracing Gems, 2019, chapter 6).
#include "ray.cl"

#define INTEGER_STEPS 256.0f
#define NEAR_ZERO (1.0f / 32.0f)
#define NEAR_ZERO_OFFSET (1.0f / 65536.0f)

static float3 offset_along(const float3 position, const float3 normal, const float ray_offset) {
    const JOIN(LANE_INT, 3) steps = JOIN(TO_LANE_INT, 3)(INTEGER_STEPS * normal);
    const float3 moved = JOIN(AS_REAL, 3)(JOIN(AS_LANE_INT, 3)(position) + (position < 0.0f ? -steps : steps));
    return fabs(position) < NEAR_ZERO ? position + NEAR_ZERO_OFFSET * normal : moved;
}

static float ray_offset(const Ray ray, const float distance, const float bound) {
    return bound;
}
