// SPDX-License-Identifier: MIT
// What arrives from a light, and the counting of rays.
#include "light.cl"
#include "ray_counts.cl"

// Direction in 0 to 3, irradiance in 4 to 6.
__kernel void lights_at(__global float8 *results, __global const Light *lights,
                        __global const float4 *points) {
    const size_t i = get_global_id(0);
    const Illumination light = light_at(lights[i], points[i].xyz);
    results[i] = (float8)(light.direction, 0.0f, light.irradiance, 0.0f);
}

// Every work-item adds its own to one row's counts.
__kernel void count_rays(__global RayCounts *rows, __global const RayCounts *counts) {
    add_ray_counts(&rows[0], counts[get_global_id(0)]);
}
