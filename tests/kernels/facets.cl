// SPDX-License-Identifier: MIT
// Rays and triangles by a way to intersect them: one of each a work-item, and closed meshes of
// four that rays are in, where every miss is a leak.
#include "packets/triangle/woop.cl"

// Of a packet of one ray the axis that it is longest along, as its walk has it; else each its own.
static TriangleRays rays_for(const WideRays *rays) {
#if WIDTH == 1
    const float x = fabs(rays->direction.x);
    const float y = fabs(rays->direction.y);
    const float z = fabs(rays->direction.z);
    return triangle_rays(rays, x > y && x > z ? 0 : y > z ? 1 : 2);
#else
    return triangle_rays(rays, ALL_AXES);
#endif
}

static Scene scene_of(__global const Facet *facets) {
    Scene scene;
    scene.facets = facets;
    return scene;
}

// In x the distance, in y and z the weights of the second and third corner.
__kernel void hit(__global float4 *hits, __global const float4 *origins,
                  __global const float4 *directions, __global const Facet *facets) {
    const size_t i = get_global_id(0);
    const Scene scene = scene_of(facets);
    WideRays rays = no_rays();
    rays.origin = wide3(origins[i].xyz);
    rays.direction = wide3(directions[i].xyz);
    const TriangleRays shared = rays_for(&rays);
    Lanes t, b, c;
    t.wide = wide_ray_triangle(&rays, &shared, &scene, i, &b.wide, &c.wide);
    hits[i] = (float4)(t.lane[0], b.lane[0], c.lane[0], 0.0f);
}

// PCG: Jarzynski and Olano, Hash Functions for GPU Rendering (Journal of Computer Graphics
// Techniques, 2020).
static uint scrambled(const uint number) {
    const uint state = number * 747796405u + 2891336453u;
    const uint word = ((state >> ((state >> 28) + 4u)) ^ state) * 277803737u;
    return (word >> 22) ^ word;
}

// In [0, 1), another with each call.
static float chance(uint *seed) {
    *seed = scrambled(*seed);
    return (*seed >> 8) * 0x1p-24f;
}

// Facet i has all four corners but the one of number i; it begins with the next.
static float3 corner_of(__global const Facet *facets, const uint corner) {
    return vload3(0, facets[(corner + 3) % 4].corners[0]);
}

static float3 somewhere_inside(__global const Facet *facets, uint *seed) {
    float3 sum = 0.0f;
    float weights = 0.0f;
    for (uint i = 0; i < 4; ++i) {
        const float weight = 0.1f + chance(seed);
        sum += weight * corner_of(facets, i);
        weights += weight;
    }
    return sum / weights;
}

// One in four a corner.
static float3 somewhere_on_an_edge(__global const Facet *facets, uint *seed) {
    const uint from = (uint)(4.0f * chance(seed));
    const uint to = from + 1 + (uint)(3.0f * chance(seed));
    const float share = max(0.0f, (4.0f * chance(seed) - 1.0f) / 3.0f);
    return mix(corner_of(facets, from), corner_of(facets, to % 4), share);
}

static WideRays aimed_at_edges(__global const Facet *facets, uint *seed) {
    Lanes3 origins, directions;
    for (int lane = 0; lane < WIDTH; ++lane) {
        const float3 origin = somewhere_inside(facets, seed);
        put_lane(&origins, lane, origin);
        put_lane(&directions, lane, unit(somewhere_on_an_edge(facets, seed) - origin));
    }
    WideRays rays = no_rays();
    rays.origin = load_lanes(&origins);
    rays.direction = load_lanes(&directions);
    return rays;
}

// How many of so many rays get out of a mesh.
__kernel void leak(__global uint *leaks, __global const uint *counts,
                   __global const Facet *facets) {
    const size_t i = get_global_id(0);
    const Scene scene = scene_of(facets + 4 * i);
    uint seed = scrambled(i);
    uint missed = 0;
    for (uint ray = 0; ray < counts[i]; ray += WIDTH) {
        const WideRays rays = aimed_at_edges(scene.facets, &seed);
        const TriangleRays shared = rays_for(&rays);
        Wide nearest = INFINITY;
        for (uint facet = 0; facet < 4; ++facet) {
            Wide b, c;
            nearest = smaller(wide_ray_triangle(&rays, &shared, &scene, facet, &b, &c), nearest);
        }
        missed += abs(sum_of_lanes(nearest == INFINITY));
    }
    leaks[i] = missed;
}
