// SPDX-License-Identifier: MIT
// Rays against boxes, each with one of its own.
#include "bvh.cl"

__kernel void enter(__global float *enters, __global const float4 *origins,
                    __global const float4 *directions, __global const BvhChild *boxes,
                    __global const float *limits) {
    const size_t i = get_global_id(0);
    const Ray ray = {origins[i].xyz, directions[i].xyz};
    const SlabRay slabs = slab_ray(ray);
    enters[i] = enter_box(&boxes[i], &slabs, limits[i]);
}
