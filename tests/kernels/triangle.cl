// SPDX-License-Identifier: MIT
// Rays and lines against triangles, each with edges of its own.
#include "triangle.cl"

__kernel void ray_triangle(__global float4 *hits, __global const float4 *origins,
                           __global const float4 *directions, __global const float4 *a,
                           __global const float4 *b, __global const float4 *c) {
    const size_t i = get_global_id(0);
    const Ray ray = {origins[i].xyz, directions[i].xyz};
    const Edges edges = {a[i].xyz, b[i].xyz - a[i].xyz, c[i].xyz - a[i].xyz};
    float2 barycentric = (float2)(-1.0f);
    const float distance = intersect_ray_triangle(ray, edges, &barycentric);
    hits[i] = (float4)(distance, barycentric, 0.0f);
}

__kernel void line_triangle(__global int *meets, __global const float4 *origins,
                            __global const float4 *destinations, __global const float4 *a,
                            __global const float4 *b, __global const float4 *c) {
    const size_t i = get_global_id(0);
    const Line line = {origins[i].xyz, destinations[i].xyz};
    const Edges edges = {a[i].xyz, b[i].xyz - a[i].xyz, c[i].xyz - a[i].xyz};
    meets[i] = intersect_line_triangle(line, edges);
}
