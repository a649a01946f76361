// SPDX-License-Identifier: MIT
// Rays and spheres, one of each a work-item.
#include "wide_sphere.cl"

__kernel void distances(__global float *results, __global const float4 *origins,
                        __global const float4 *directions, __global const float4 *spheres) {
    const size_t i = get_global_id(0);
    WideRays rays = no_rays();
    rays.origin = wide3(origins[i].xyz);
    rays.direction = wide3(directions[i].xyz);
    rays.limit = INFINITY;
    results[i] = wide_ray_sphere(&rays, spheres[i].xyz, spheres[i].w);
}
