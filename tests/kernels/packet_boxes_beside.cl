// SPDX-License-Identifier: MIT
// A ray and the box of a node's first child, one of each a work-item.
#include "packets/walk/beam.cl"

// Whether the ray is said to enter it, alone, in its beam and in its packet: it is in every lane.
__kernel void enter_all_ways(__global int *enters, __global const float4 *origins,
                             __global const float4 *directions, __global const BvhNode *nodes) {
    const size_t i = get_global_id(0);
    WideRays rays[PACKETS];
    PerPacket t_max_each = INFINITY;
    for (int packet = 0; packet < PACKETS; ++packet) {
        rays[packet].origin = wide3(origins[i].xyz);
        rays[packet].direction = wide3(directions[i].xyz);
        rays[packet].t_max = INFINITY;
    }
    const SlabRays slabs = slab_rays(&rays[0]);
    Beam beam;
    beam_of(&beam, rays);
    float at[4];
    const bool alone = any_lane(enter_box(&nodes[i], 0, &slabs, rays[0].t_max) < NOT_ENTERED);
    const bool in_beam = enter_boxes(&nodes[i], &beam, INFINITY, at) & 1;
    // Not by &&: LLVM 19, in PoCL 6.0, ends the process over a condition that a packet's constant 1
    // closes.
    enters[i] = alone & in_beam & packets_in(&nodes[i], 0, &beam, t_max_each);
}

#define RAYS (PACKETS * WIDTH)

// The ray in one lane, and in the `count` lanes after it the other. All others have none.
static void in_lanes(WideRays *rays, const int ray_lane, const float3 origin,
                     const float3 direction, const float3 other, const int count) {
    for (int packet = 0; packet < PACKETS; ++packet) {
        Lanes3 directions;
        Lanes t_max_each;
        for (int lane = 0; lane < WIDTH; ++lane) {
            const int after = (packet * WIDTH + lane - ray_lane + RAYS) % RAYS;
            put_lane(&directions, lane, after == 0 ? direction : other);
            t_max_each.lane[lane] = after <= count ? INFINITY : -1.0f;
        }
        rays[packet].origin = wide3(origin);
        rays[packet].direction = load_lanes(&directions);
        rays[packet].t_max = t_max_each.wide;
    }
}

// What becomes of a ray: the children whose boxes its beam enters, the bits of where it enters the
// first, whether its packet enters that, and whether the ray hits the triangle there. `others` is
// how many of the other rays do.
static int4 told(__global const BvhNode *node, const Scene *scene, const WideRays *rays,
                 const int ray_lane, int *others) {
    Beam beam;
    beam_of(&beam, rays);
    float each[4];
    const int children = enter_boxes(node, &beam, INFINITY, each);
    const int packets = packets_in(node, 0, &beam, INFINITY);
    int hits = 0;
    *others = 0;
    for (int packet = 0; packet < PACKETS; ++packet) {
        const SlabRays slabs = slab_rays(&rays[packet]);
        const TriangleRays shared = triangle_rays(&rays[packet], beam.axis);
        Wide b, c;
        LanesInt hit;
        hit.wide =
            (enter_box(node, 0, &slabs, rays[packet].t_max) < NOT_ENTERED)
            & (wide_ray_triangle(&rays[packet], &shared, scene, 0, &b, &c) < rays[packet].t_max);
        for (int lane = 0; lane < WIDTH; ++lane) {
            if (packet * WIDTH + lane == ray_lane) {
                hits = hit.lane[lane] != 0;
            } else {
                *others += hit.lane[lane] != 0;
            }
        }
    }
    return (int4)(children, as_int(each[0]), packets >> ray_lane / WIDTH & 1, hits);
}

// In x whether the ray is said to hit the triangle in the first child's box, in y whether what it
// is told hangs on the rays beside it, in z how many of those hit.
__kernel void enter_beside(__global int4 *results, __global const float4 *origins,
                           __global const float4 *directions, __global const float4 *others,
                           __global const int *counts, __global const BvhNode *nodes,
                           __global const Single4 *corners) {
    const size_t i = get_global_id(0);
    const int lane = i % RAYS;
    Scene scene;
    scene.triangle_corners = &corners[3 * i];
    WideRays rays[PACKETS];
    int hits;
    in_lanes(rays, lane, origins[i].xyz, directions[i].xyz, others[i].xyz, 0);
    const int4 alone = told(&nodes[i], &scene, rays, lane, &hits);
    in_lanes(rays, lane, origins[i].xyz, directions[i].xyz, others[i].xyz, counts[i]);
    const int4 beside = told(&nodes[i], &scene, rays, lane, &hits);
    results[i] = (int4)((beside.x & 1) & beside.z & beside.w, any(alone != beside), hits, 0);
}
