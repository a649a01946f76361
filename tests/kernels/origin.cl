// SPDX-License-Identifier: MIT
// How far off a surface a ray starts, and where.
#include "origin.cl"

// `rays`: the origin, and in w the distance at which it has met the surface. `positions`: in w the
// shape's bound. In w of the result the offset.
__kernel void offsets(__global float4 *results, __global const float4 *rays,
                      __global const float4 *positions, __global const float4 *normals) {
    const size_t i = get_global_id(0);
    const Ray ray = {rays[i].xyz, (float3)(0.0f, 0.0f, 1.0f)};
    const float offset = ray_offset(ray, rays[i].w, positions[i].w);
    results[i] = (float4)(offset_along(positions[i].xyz, normals[i].xyz, offset), offset);
}
