// SPDX-License-Identifier: MIT
// A ray and the box of a node's first child, one of each a work-item.
#include "bvh.cl"

// Whether the ray is said to enter it, alone, in its beam and in its packet: it is in every lane.
__kernel void enter_all_ways(__global int *enters, __global const float4 *origins,
                             __global const float4 *directions, __global const BvhNode *nodes) {
    const size_t i = get_global_id(0);
    WideRays rays[PACKETS];
    PerPacket limits = INFINITY;
    for (int packet = 0; packet < PACKETS; ++packet) {
        rays[packet].origin = wide3(origins[i].xyz);
        rays[packet].direction = wide3(directions[i].xyz);
        rays[packet].limit = INFINITY;
    }
    const SlabRays slabs = slab_rays(&rays[0]);
    Beam beam;
    beam_of(&beam, rays);
    Boxes at;
    const bool alone = any_lane(enter_box(&nodes[i], 0, &slabs, rays[0].limit));
    const bool in_beam = enter_boxes(&nodes[i], &beam, INFINITY, &at) & 1;
    enters[i] = alone && in_beam && (packets_in(&nodes[i], 0, &beam, limits) & 1);
}
