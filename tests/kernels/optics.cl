// SPDX-License-Identifier: MIT
// Glass: the functions of dielectric.cl, and the rays that it puts on the stack.
#include "dielectric.cl"

// In w whether there is such a direction.
__kernel void refracted(__global float4 *results, __global const float4 *directions,
                        __global const float4 *normals, __global const float *ratios) {
    const size_t i = get_global_id(0);
    float3 result = (float3)(0.0f);
    const bool passes = refract(directions[i].xyz, normals[i].xyz, ratios[i], &result);
    results[i] = (float4)(result, passes);
}

__kernel void fresnels(__global float *results, __global const float *cosines,
                       __global const float *iors) {
    const size_t i = get_global_id(0);
    results[i] = fresnel(cosines[i], iors[i]);
}

__kernel void transmittances(__global float4 *results, __global const float4 *absorptions,
                             __global const float *distances) {
    const size_t i = get_global_id(0);
    results[i] = (float4)(transmittance(absorptions[i].xyz, distances[i]), 0.0f);
}

// `media`: index of refraction, and 1 where the surface is seen from behind; in the result the
// refracted direction, and in w the reflectance.
__kernel void interfaces(__global float4 *results, __global const float4 *directions,
                         __global const float4 *normals, __global const float2 *media) {
    const size_t i = get_global_id(0);
    Surface surface;
    surface.normal = normals[i].xyz;
    surface.from_behind = media[i].y > 0.0f;
    const Interface interface = interface_at(&surface, directions[i].xyz, media[i].x);
    results[i] = (float4)(interface.refracted, interface.reflectance);
}

// The same on a facet of a smooth mesh.
__kernel void smooth_interfaces(__global float4 *results, __global const float4 *directions,
                                __global const float4 *normals, __global const float4 *facets,
                                __global const float2 *media) {
    const size_t i = get_global_id(0);
    Surface surface;
    surface.normal = normals[i].xyz;
    surface.geometric_normal = facets[i].xyz;
    surface.from_behind = media[i].y > 0.0f;
    const Interface interface = interface_at(&surface, directions[i].xyz, media[i].x);
    results[i] = (float4)(interface.refracted, interface.reflectance);
}

__kernel void chords(__global float *results, __global const float4 *origins,
                     __global const float4 *directions, __global const float4 *centers) {
    const size_t i = get_global_id(0);
    const Ray ray = {origins[i].xyz, directions[i].xyz};
    results[i] = intersect_ray_inside_sphere(ray, centers[i].xyz);
}

typedef struct SpawnedRay {
    float4 origin;
    float4 direction;
    float4 weight;      // depth in w
    float4 absorption;  // 0 when there is no such ray, else 1, in w
} SpawnedRay;

typedef struct Spawned {
    SpawnedRay rays[2];  // in the order in which they were pushed
    uint4 counts;        // reflection, refraction, dropped
} Spawned;

static SpawnedRay spawned_ray(const RayStack *stack, const int i) {
    SpawnedRay result = {0.0f, 0.0f, 0.0f, 0.0f};
    if (i < stack->count) {
        const PendingRay ray = stack->rays[i];
        result.origin.xyz = ray.ray.origin;
        result.direction.xyz = ray.ray.direction;
        result.weight = (float4)(ray.weight, ray.depth);
        result.absorption = (float4)(ray.absorption, 1.0f);
    }
    return result;
}

// A ray of weight 1, in a medium that absorbs 0.5, meets a glass sphere at its point `point`, where
// `normal` faces the ray. `media`: index of refraction, from behind, depth.
__kernel void spawn(__global Spawned *results, __global const float4 *directions,
                    __global const float4 *normals, __global const float4 *points,
                    __global const float4 *media, __global const float4 *spheres,
                    __global const float4 *absorptions) {
    const size_t i = get_global_id(0);
    Surface surface;
    surface.position = points[i].xyz;
    surface.normal = normals[i].xyz;
    surface.geometric_normal = surface.normal;
    surface.from_behind = media[i].y > 0.0f;
    surface.ray_offset = 1e-5f * spheres[i].w;
    DielectricMaterial glass;
    glass.absorption = absorptions[i];
    glass.ior = media[i].x;
    glass.medium = 0;
    PendingRay incoming;
    incoming.ray.origin = surface.position - directions[i].xyz;
    incoming.ray.direction = directions[i].xyz;
    incoming.weight = (float3)(1.0f);
    incoming.depth = convert_int(media[i].z);
    incoming.media = 0;
    incoming.absorption = (float3)(0.5f);
    RayStack stack;
    stack.count = 0;
    RayCounts counts = {0, 0, 0, 0, 0, 0};
    if (METHOD_INTERIOR_PAPER) {
        spawn_through_sphere(&stack, &incoming, &surface, &glass, spheres[i].xyz, (float3)(1.0f),
                             &counts);
    } else {
        spawn_dielectric(0, &stack, &incoming, &surface, &glass, (float3)(1.0f), &counts);
    }
    results[i].rays[0] = spawned_ray(&stack, 0);
    results[i].rays[1] = spawned_ray(&stack, 1);
    results[i].counts = (uint4)(counts.reflection, counts.refraction, counts.dropped, 0);
}
