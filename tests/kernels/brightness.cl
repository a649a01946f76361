// SPDX-License-Identifier: MIT
// How bright a white surface is under a point light: by the light that the stages up to 08 find
// there, and by that of those that trace rays side by side.
#include "packets/light.cl"

static float lit(const float cosine, const float share) {
    return cosine > 0.0f ? cosine * share : 0.0f;
}

__kernel void brightness(__global float2 *results, __global const Light *lights,
                         __global const float4 *points, __global const float4 *normals) {
    const size_t i = get_global_id(0);
    const Illumination one = light_at(lights[i], points[i].xyz);
    const WideIllumination wide = wide_light_at(lights[i], wide3(points[i].xyz));
    results[i] = (float2)(lit(dot(normals[i].xyz, one.direction), one.irradiance.x),
                          lit(wide_dot(wide3(normals[i].xyz), wide.direction).s0,
                              wide.share.s0 * lights[i].color.x));
}
