// SPDX-License-Identifier: MIT
// Off a surface by a distance that suits scenes some units wide, and no others.
#include "ray.cl"

#define FIXED_OFFSET 1e-3f

static float3 offset_along(const float3 position, const float3 normal, const float ray_offset) {
    return position + FIXED_OFFSET * normal;
}

static float ray_offset(const Ray ray, const float distance, const float bound) {
    return FIXED_OFFSET;
}
