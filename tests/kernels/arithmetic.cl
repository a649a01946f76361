// SPDX-License-Identifier: MIT
// What rounding, and a compiler that was allowed more, makes of a few lines of arithmetic.
#include "packets/normalise/exact.cl"
#include "packets/sphere.cl"

typedef struct Units {
    float4 one, wide;
} Units;

static float4 from_wide(const Wide3 a) {
    return (float4)(a.x.s0, a.y.s0, a.z.s0, 0.0f);
}

__kernel void units(__global Units *results, __global const float4 *vectors) {
    const size_t i = get_global_id(0);
    const float3 vector = vectors[i].xyz;
    results[i].one = (float4)(normalize(vector), 0.0f);
    results[i].wide = from_wide(wide_normalize(wide3(vector)));
}

// The other side of a right triangle; `side` is never above `longest`.
__kernel void other_sides(__global float *results, __global const float *longest,
                          __global const float *side) {
    const size_t i = get_global_id(0);
    results[i] = sqrt(longest[i] * longest[i] - side[i] * side[i]);
}

__kernel void spheres(__global float *distances, __global const float4 *origins,
                      __global const float4 *directions) {
    const size_t i = get_global_id(0);
    WideRays rays = no_rays();
    rays.origin = wide3(origins[i].xyz);
    rays.direction = wide3(directions[i].xyz);
    rays.t_max = INFINITY;
    const Wide distance = wide_ray_sphere(&rays, (float3)(0.0f), 1.0f);
    const Wide hits = distance < rays.t_max ? distance : (Wide)(-1.0f);
    distances[i] = hits.s0;
}

// The smaller and the larger of two numbers, and whether the first is one.
__kernel void choices(__global float4 *results, __global const float *first,
                      __global const float *second) {
    const size_t i = get_global_id(0);
    results[i] = (float4)(MIN(first[i], second[i]), MAX(first[i], second[i]),
                          isnan(first[i]) ? 0.0f : 1.0f, first[i] == first[i] ? 1.0f : 0.0f);
}
