// SPDX-License-Identifier: MIT
// Mirrored rays, and the stack that rays wait on.
#include "reflection.cl"

// Origin in 0 to 3, direction in 4 to 6, from a surface at the point 0 with the offset 1.
__kernel void reflected(__global float8 *rays, __global const float4 *directions,
                        __global const float4 *normals, __global const float4 *geometric_normals) {
    const size_t i = get_global_id(0);
    Surface surface;
    surface.position = (float3)(0.0f);
    surface.normal = normals[i].xyz;
    surface.geometric_normal = geometric_normals[i].xyz;
    surface.ray_offset = 1.0f;
    const Ray ray = reflected_ray(&surface, directions[i].xyz);
    rays[i] = (float8)(ray.origin, 0.0f, ray.direction, 0.0f);
}

// After the primary ray is taken, pushes rays 1, 2 and 3 of depth d, d + 1 and d + 2; gives the
// order in which they are taken (as decimal digits), how many were traced and dropped, and the
// primary ray's depth.
__kernel void stack(__global int4 *results, __global const int *depths) {
    const size_t i = get_global_id(0);
    const Ray primary = {(float3)(0.0f), (float3)(0.0f, 0.0f, 1.0f)};
    RayStack stack;
    stack.rays[0] = primary_ray(primary);
    stack.count = 1;
    PendingRay ray = stack.rays[--stack.count];
    const int primary_depth = ray.depth;
    uint traced = 0;
    RayCounts counts = {0, 0, 0, 0, 0, 0};
    for (int k = 0; k < 3; ++k) {
        ray.depth = depths[i] + k;
        ray.weight = (float3)(k + 1);
        push_ray(&stack, ray, &traced, &counts);
    }
    int order = 0;
    while (stack.count > 0) {
        order = 10 * order + convert_int(stack.rays[--stack.count].weight.x);
    }
    results[i] = (int4)(order, traced, counts.dropped, primary_depth);
}

// Traced, dropped, cut off, and their weight: what becomes of one ray of that weight, and of depth
// in w.
__kernel void cut_off(__global uint4 *results, __global const float4 *weights) {
    const size_t i = get_global_id(0);
    const Ray primary = {(float3)(0.0f), (float3)(0.0f, 0.0f, 1.0f)};
    RayStack stack;
    stack.count = 0;
    PendingRay ray = primary_ray(primary);
    ray.weight = weights[i].xyz;
    ray.depth = convert_int(weights[i].w);
    uint traced = 0;
    RayCounts counts = {0, 0, 0, 0, 0, 0};
    push_ray(&stack, ray, &traced, &counts);
    results[i] = (uint4)(traced, counts.dropped, counts.cut_off, counts.cut_off_weight);
}

// Depth and reflection count in w of the results: what spawn_reflected puts on the stack.
__kernel void spawned(__global float8 *results, __global const int *depths) {
    const size_t i = get_global_id(0);
    PendingRay incoming;
    incoming.ray.origin = (float3)(0.0f, 0.0f, 1.0f);
    incoming.ray.direction = (float3)(0.6f, 0.0f, -0.8f);
    incoming.weight = (float3)(1.0f);
    incoming.depth = depths[i];
    Surface surface;
    surface.position = (float3)(0.75f, 0.0f, 0.0f);
    surface.normal = (float3)(0.0f, 0.0f, 1.0f);
    surface.geometric_normal = surface.normal;
    surface.ray_offset = 0.0f;
    RayStack stack;
    stack.count = 0;
    RayCounts counts = {0, 0, 0, 0, 0, 0};
    spawn_reflected(&stack, &incoming, &surface, (float3)(0.25f, 0.5f, 0.75f), &counts);
    const PendingRay ray = stack.rays[0];
    results[i] = stack.count == 1 ? (float8)(ray.ray.direction, ray.depth, ray.weight,
                                             counts.reflection + 10 * counts.dropped)
                                  : (float8)(counts.reflection + 10 * counts.dropped);
}
