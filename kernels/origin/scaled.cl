// SPDX-License-Identifier: MIT
// Off a surface by some thirty units in the last place of the largest number that went into the hit point.
#include "ray.cl"

#define SCALED_OFFSET 2e-6f

static float3 offset_along(const float3 position, const float3 normal, const float ray_offset) {
    return position + ray_offset * normal;
}

static float ray_offset(const Ray ray, const float distance, const float bound) {
    const float3 size = fabs(ray.origin);
    return SCALED_OFFSET * (max(size.x, max(size.y, size.z)) + distance);
}
