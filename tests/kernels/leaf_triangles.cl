// SPDX-License-Identifier: MIT
// Rays and triangles by a way to intersect them: one of each a work-item, and closed meshes of
// four that rays are in, where every miss is a leak.
#include "box/robust.cl"
#include "sphere.cl"
#include "triangle.cl"
#if WIDTH == 1
#include "tree.cl"

typedef Ray Rays;

static Rays rays_of(const float3 *origins, const float3 *directions) {
    const Ray ray = {origins[0], directions[0]};
    return ray;
}

static void meet(const Scene *scene, const Rays *rays, const int index, float *t,
                 float2 *barycentric) {
    t[0] = intersect_triangle(*rays, scene, index, barycentric);
}
#else
#include "packets/triangle/woop.cl"

typedef WideRays Rays;

static Rays rays_of(const float3 *origins, const float3 *directions) {
    Lanes3 from, along;
    for (int lane = 0; lane < WIDTH; ++lane) {
        put_lane(&from, lane, origins[lane]);
        put_lane(&along, lane, directions[lane]);
    }
    WideRays rays = no_rays();
    rays.origin = load_lanes(&from);
    rays.direction = load_lanes(&along);
    return rays;
}

// Each ray by the axis that it is longest along.
static void meet(const Scene *scene, const Rays *rays, const int index, float *t,
                 float2 *barycentric) {
    const TriangleRays shared = triangle_rays(rays, ALL_AXES);
    Lanes distance, b, c;
    distance.wide = wide_ray_triangle(rays, &shared, scene, index, &b.wide, &c.wide);
    for (int lane = 0; lane < WIDTH; ++lane) {
        t[lane] = distance.lane[lane];
        barycentric[lane] = (float2)(b.lane[lane], c.lane[lane]);
    }
}
#endif

static Scene scene_of(__global const Single4 *corners) {
    Scene scene;
    scene.triangle_corners = corners;
    return scene;
}

// In x the distance, in y and z the weights of the second and third corner.
__kernel void hit(__global float4 *hits, __global const float4 *origins,
                  __global const float4 *directions, __global const Single4 *corners) {
    const size_t i = get_global_id(0);
    const Scene scene = scene_of(corners);
    float3 from[WIDTH], along[WIDTH];
    for (int lane = 0; lane < WIDTH; ++lane) {
        from[lane] = origins[i].xyz;
        along[lane] = directions[i].xyz;
    }
    const Rays rays = rays_of(from, along);
    float t[WIDTH];
    float2 barycentric[WIDTH];
    meet(&scene, &rays, i, t, barycentric);
    hits[i] = (float4)(t[0], barycentric[0], 0.0f);
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

// Triangle i has all four corners of the mesh but the one of number i; it begins with the next.
static float3 corner_of(__global const Single4 *corners, const uint corner) {
    return XYZ(corners[3 * ((corner + 3) % 4)]);
}

static float3 somewhere_inside(__global const Single4 *corners, uint *seed) {
    float3 sum = 0.0f;
    float weights = 0.0f;
    for (uint i = 0; i < 4; ++i) {
        const float weight = 0.1f + chance(seed);
        sum += weight * corner_of(corners, i);
        weights += weight;
    }
    return sum / weights;
}

// One in four a corner.
static float3 somewhere_on_an_edge(__global const Single4 *corners, uint *seed) {
    const uint from = (uint)(4.0f * chance(seed));
    const uint to = from + 1 + (uint)(3.0f * chance(seed));
    const float share = max(0.0f, (4.0f * chance(seed) - 1.0f) / 3.0f);
    return mix(corner_of(corners, from), corner_of(corners, to % 4), share);
}

static Rays aimed_at_edges(__global const Single4 *corners, uint *seed) {
    float3 origins[WIDTH], directions[WIDTH];
    for (int lane = 0; lane < WIDTH; ++lane) {
        origins[lane] = somewhere_inside(corners, seed);
        directions[lane] = normalize(somewhere_on_an_edge(corners, seed) - origins[lane]);
    }
    return rays_of(origins, directions);
}

// How many of so many rays get out of a mesh.
__kernel void leak(__global uint *leaks, __global const uint *counts,
                   __global const Single4 *corners) {
    const size_t i = get_global_id(0);
    const Scene scene = scene_of(corners + 3 * 4 * i);
    uint seed = scrambled(i);
    uint missed = 0;
    for (uint ray = 0; ray < counts[i]; ray += WIDTH) {
        const Rays rays = aimed_at_edges(scene.triangle_corners, &seed);
        bool meets[WIDTH] = {false};
        for (uint triangle = 0; triangle < 4; ++triangle) {
            float t[WIDTH];
            float2 barycentric[WIDTH];
            meet(&scene, &rays, triangle, t, barycentric);
            for (int lane = 0; lane < WIDTH; ++lane) {
                meets[lane] |= t[lane] < INFINITY;
            }
        }
        for (int lane = 0; lane < WIDTH; ++lane) {
            missed += !meets[lane];
        }
    }
    leaks[i] = missed;
}
