// SPDX-License-Identifier: MIT
// How much light facets of smooth meshes get, in the first lane.
#include "packets/terminator/hanika.cl"

__kernel void shadowings(__global float *results, __global const float4 *facets,
                         __global const float4 *normals, __global const float4 *directions) {
    const size_t i = get_global_id(0);
    WideSurfaces surfaces;
    surfaces.geometric_normal = wide3(facets[i].xyz);
    surfaces.normal = wide3(normals[i].xyz);
    const Wide3 direction = wide3(directions[i].xyz);
    results[i] = wide_shadowing(&surfaces, direction, wide_dot(surfaces.normal, direction)).s0;
}
