// SPDX-License-Identifier: MIT
// As origin.cl, of WIDTH rays side by side, the last of which is read.
#include "packets/origin.cl"

__kernel void offsets(__global float4 *results, __global const float4 *all_rays,
                      __global const float4 *positions, __global const float4 *normals) {
    const size_t i = get_global_id(0);
    WideRays rays = no_rays();
    rays.origin = wide3(all_rays[i].xyz);
    rays.t_max = all_rays[i].w;
    WideSurfaces surfaces;
    surfaces.position = wide3(positions[i].xyz);
    surfaces.ray_offset = wide_ray_offset(&rays, positions[i].w);
    Lanes3 origins;
    Lanes offsets;
    store_lanes(&origins, wide_offset_along(&surfaces, wide3(normals[i].xyz)));
    offsets.wide = surfaces.ray_offset;
    results[i] = (float4)(get_lane(&origins, WIDTH - 1), offsets.lane[WIDTH - 1]);
}
