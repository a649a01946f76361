// SPDX-License-Identifier: MIT
// Packets of rays against the boxes of a node, each with one of its own.
#include "packets/walk/beam.cl"

// The ray in one lane of one packet, and one beside it that is not a number. All others have none.
static void in_lane(WideRays *rays, const int packet, const int lane, const float4 origin,
                    const float4 direction, const float t_max) {
    Lanes3 origins, directions;
    Lanes t_max_each;
    for (int p = 0; p < PACKETS; ++p) {
        for (int i = 0; i < WIDTH; ++i) {
            const bool is_nan = i == (lane + 1) % WIDTH;
            put_lane(&origins, i, (float3)(7.0f));
            put_lane(&directions, i, is_nan ? (float3)(NAN) : (float3)(-1.0f, 2.0f, 3.0f));
            t_max_each.lane[i] = is_nan ? INFINITY : -1.0f;
        }
        if (p == packet) {
            put_lane(&origins, lane, origin.xyz);
            put_lane(&directions, lane, direction.xyz);
            t_max_each.lane[lane] = t_max;
        }
        rays[p].origin = load_lanes(&origins);
        rays[p].direction = load_lanes(&directions);
        rays[p].t_max = t_max_each.wide;
    }
}

// Of the first child: in x whether the ray enters it, in y where its beam does, INFINITY for not;
// in z the bits of the children that the beam enters; in w whether the ray's packet enters the
// first.
__kernel void enter(__global float4 *results, __global const float4 *origins,
                    __global const float4 *directions, __global const BvhNode *nodes,
                    __global const float *t_max_each) {
    const size_t i = get_global_id(0);
    const int lane = i % WIDTH;
    const int packet = i / WIDTH % PACKETS;
    WideRays rays[PACKETS];
    in_lane(rays, packet, lane, origins[i], directions[i], t_max_each[i]);
    const SlabRays slabs = slab_rays(&rays[packet]);
    Beam beam;
    beam_of(&beam, rays);
    LanesInt enters;
    enters.wide = enter_box(&nodes[i], 0, &slabs, rays[packet].t_max) < NOT_ENTERED;
    float each[4];
    const int found = enter_boxes(&nodes[i], &beam, t_max_each[i], each);
    results[i] = (float4)(enters.lane[lane] != 0, (found & 1) ? each[0] : INFINITY, found,
                          packets_in(&nodes[i], 0, &beam, t_max_each[i]) >> packet & 1);
}

// Of a beam of all rays of a work-item, from `first` on: in x the bits of the children that it
// enters, in y of those that any ray enters, in z of those that a ray enters and its packet is said
// not to.
__kernel void enter_together(__global int4 *results, __global const float4 *origins,
                             __global const float4 *directions, __global const BvhNode *nodes) {
    const size_t i = get_global_id(0);
    const size_t first = i / (WIDTH * PACKETS) * (WIDTH * PACKETS);
    WideRays rays[PACKETS];
    for (int packet = 0; packet < PACKETS; ++packet) {
        Lanes3 from, along;
        for (int lane = 0; lane < WIDTH; ++lane) {
            put_lane(&from, lane, origins[first + packet * WIDTH + lane].xyz);
            put_lane(&along, lane, directions[first + packet * WIDTH + lane].xyz);
        }
        rays[packet].origin = load_lanes(&from);
        rays[packet].direction = load_lanes(&along);
        rays[packet].t_max = INFINITY;
    }
    Beam beam;
    beam_of(&beam, rays);
    float at[4];
    int by_a_ray = 0;
    int without_packet = 0;
    for (int packet = 0; packet < PACKETS; ++packet) {
        const SlabRays slabs = slab_rays(&rays[packet]);
        for (int child = 0; child < 4; ++child) {
            if (any_lane(enter_box(&nodes[i], child, &slabs, INFINITY) < NOT_ENTERED)) {
                by_a_ray |= 1 << child;
                const int in = packets_in(&nodes[i], child, &beam, INFINITY);
                without_packet |= (in >> packet & 1) ? 0 : 1 << child;
            }
        }
    }
    results[i] = (int4)(enter_boxes(&nodes[i], &beam, INFINITY, at), by_a_ray, without_packet, 0);
}
