// SPDX-License-Identifier: MIT
// Rays against the boxes of a node, each with one of its own.
#include "bvh.cl"


// The ray in one lane; where there is room, one beside it that is not a number. All others have none.
static WideRays in_lane(const int lane, const float4 origin, const float4 direction,
                        const float limit) {
    Lanes3 origins, directions;
    float limits[WIDTH];
    for (int i = 0; i < WIDTH; ++i) {
        put_lane(&origins, i, (float3)(7.0f));
        put_lane(&directions, i, i == (lane + 1) % WIDTH ? (float3)(NAN) : (float3)(-1.0f, 2.0f, 3.0f));
        limits[i] = i == (lane + 1) % WIDTH ? INFINITY : -1.0f;
    }
    put_lane(&origins, lane, origin.xyz);
    put_lane(&directions, lane, direction.xyz);
    limits[lane] = limit;
    const WideRays rays = {load_lanes(&origins), load_lanes(&directions), LOAD_WIDE(limits)};
    return rays;
}

// Of the first child: in x whether the ray enters it, in y where its beam does, INFINITY for not; in z
// the bits of the children that the beam enters.
__kernel void enter(__global float4 *results, __global const float4 *origins,
                    __global const float4 *directions, __global const BvhNode *nodes,
                    __global const float *limits) {
    const size_t i = get_global_id(0);
    const int lane = i % WIDTH;
    const WideRays rays = in_lane(lane, origins[i], directions[i], limits[i]);
    const SlabRays slabs = slab_rays(&rays);
    const Beam beam = beam_of(&rays, &slabs);
    int enters[WIDTH];
    STORE_WIDE(enter_box(&nodes[i], 0, &slabs, rays.limit), enters);
    Boxes at;
    float each[BVH_WIDTH];
    const int found = enter_boxes(&nodes[i], &beam, limits[i], &at);
    STORE_BOXES(at, each);
    results[i] = (float4)(enters[lane] != 0, (found & 1) ? each[0] : INFINITY, found, 0.0f);
}

// Of a beam of WIDTH rays, from `first` on: in x the bits of the children that it enters, in y of those
// that any ray enters.
__kernel void enter_together(__global int2 *results, __global const float4 *origins,
                             __global const float4 *directions, __global const BvhNode *nodes) {
    const size_t i = get_global_id(0);
    const size_t first = i / WIDTH * WIDTH;
    Lanes3 from, along;
    for (int lane = 0; lane < WIDTH; ++lane) {
        put_lane(&from, lane, origins[first + lane].xyz);
        put_lane(&along, lane, directions[first + lane].xyz);
    }
    const WideRays rays = {load_lanes(&from), load_lanes(&along), INFINITY};
    const SlabRays slabs = slab_rays(&rays);
    const Beam beam = beam_of(&rays, &slabs);
    Boxes at;
    int any = 0;
    for (int child = 0; child < BVH_WIDTH; ++child) {
        any |= any_lane(enter_box(&nodes[i], child, &slabs, rays.limit)) << child;
    }
    results[i] = (int2)(enter_boxes(&nodes[i], &beam, INFINITY, &at), any);
}
