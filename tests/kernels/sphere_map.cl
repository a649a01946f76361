// SPDX-License-Identifier: MIT
// Where on a picture a point of a sphere lies, beside what goes wrong with it.
#include "texture_coordinates.cl"

// Without the clamp.
static float2 unclamped(const float3 normal) {
    return (float2)(0.5f + atan2(normal.x, normal.z) / (2.0f * M_PI_F),
                    0.5f - asin(normal.y) / M_PI_F);
}

// As the paper has it (section 7), but for the axis: pi twice too large under v.
static float2 paper(const float3 normal) {
    return (float2)(0.5f + atan2(normal.x, normal.z) / (2.0f * M_PI_F),
                    0.5f - asin(normal.y) / (2.0f * M_PI_F));
}

// u and v by each: clamped, unclamped, the paper's.
__kernel void sphere_maps(__global float8 *results, __global const float4 *normals) {
    const size_t i = get_global_id(0);
    const float3 normal = normals[i].xyz;
    results[i] =
        (float8)(sphere_texture_coordinates(normal), unclamped(normal), paper(normal), 0.0f, 0.0f);
}
