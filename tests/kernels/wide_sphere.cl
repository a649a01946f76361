// SPDX-License-Identifier: MIT
// Rays and spheres, one of each a work-item, by each way to intersect them.
#include "wide_sphere.cl"

#define RAY_SPHERE(method)                                                                        \
    __kernel void method(__global float *distances, __global const float4 *origins,               \
                         __global const float4 *directions, __global const float4 *spheres) {     \
        const size_t i = get_global_id(0);                                                        \
        WideRays rays = no_rays();                                                                \
        rays.origin = wide3(origins[i].xyz);                                                      \
        rays.direction = wide3(directions[i].xyz);                                                \
        rays.limit = INFINITY;                                                                    \
        distances[i] =                                                                            \
            JOIN(wide_ray_sphere_, method)(&rays, spheres[i].xyz, spheres[i].w);                  \
    }

RAY_SPHERE(haines)
RAY_SPHERE(geometric)
RAY_SPHERE(textbook)
