// SPDX-License-Identifier: MIT
// What rays and lines find in a whole scene.
#include "each_shape.cl"
#include "closest_hit.cl"
#include "any_hit.cl"
#include "surface.cl"
#include "diffuse.cl"

typedef struct Found {
    float4 position;          // distance in w
    float4 normal;            // offset in w
    float4 geometric_normal;  // from_behind in w
    float2 texture_coordinates;
    int shape;
    int material;
} Found;

__kernel void closest(__global Found *results, __global const float4 *origins,
                      __global const float4 *directions,
#include "scene_parameters.inc"
) {
    const Scene scene = {
#include "scene_members.inc"
    };
    const size_t i = get_global_id(0);
    const Ray ray = {origins[i].xyz, directions[i].xyz};
    const Hit hit = closest_hit(&scene, ray);
    Found found = {};
    found.shape = hit.shape;
    found.position.w = hit.distance;
    if (hit.shape != SHAPE_NONE) {
        const Surface surface = surface_at(&scene, ray, hit);
        found.position.xyz = surface.position;
        found.normal = (float4)(surface.normal, surface.ray_offset);
        found.geometric_normal = (float4)(surface.geometric_normal, surface.from_behind);
        found.material = surface.material;
        if (HAS_TEXTURES) {
            found.texture_coordinates = surface.texture_coordinates;
        }
    }
    results[i] = found;
}

__kernel void any_ray(__global int *results, __global const float4 *origins,
                      __global const float4 *directions,
#include "scene_parameters.inc"
) {
    const Scene scene = {
#include "scene_members.inc"
    };
    const size_t i = get_global_id(0);
    const Ray ray = {origins[i].xyz, directions[i].xyz};
    results[i] = any_hit_ray(&scene, ray);
}

__kernel void any_line(__global int *results, __global const float4 *origins,
                       __global const float4 *destinations,
#include "scene_parameters.inc"
) {
    const Scene scene = {
#include "scene_members.inc"
    };
    const size_t i = get_global_id(0);
    const Line line = {origins[i].xyz, destinations[i].xyz};
    results[i] = any_hit_line(&scene, line);
}

// In w the number of shadow rays; -1 where nothing was hit.
__kernel void direct(__global float4 *results, __global const float4 *origins,
                     __global const float4 *directions,
#include "scene_parameters.inc"
) {
    const Scene scene = {
#include "scene_members.inc"
    };
    const size_t i = get_global_id(0);
    const Ray ray = {origins[i].xyz, directions[i].xyz};
    const Hit hit = closest_hit(&scene, ray);
    results[i] = (float4)(0.0f, 0.0f, 0.0f, -1.0f);
    if (hit.shape != SHAPE_NONE) {
        const Surface surface = surface_at(&scene, ray, hit);
        RayCounts counts = {0, 0, 0, 0, 0, 0};
        const float3 light = direct_light(&scene, &surface, &counts);
        results[i] = (float4)(light, counts.shadow);
    }
}
