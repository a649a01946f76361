// SPDX-License-Identifier: MIT
// Packets of rays and spheres, one of each a work-item.
#include "packets/sphere.cl"

__kernel void distances(__global float *results, __global const float4 *origins,
                        __global const float4 *directions, __global const float4 *spheres) {
    const size_t i = get_global_id(0);
    WideRays rays = no_rays();
    rays.origin = wide3(origins[i].xyz);
    rays.direction = wide3(directions[i].xyz);
    rays.t_max = INFINITY;
    const Wide distances = wide_ray_sphere(&rays, spheres[i].xyz, spheres[i].w);
    results[i] = distances.s0;
}
