// SPDX-License-Identifier: MIT
// Exercise 09.1, solved: a node counts for each packet that it is looked into for.

// kernels/wide.cl
// #region packet
#define HOT 64

// A packet of rays. A lane without a ray has a limit below 0, and hits nothing.
typedef struct WideRays {
    Wide3 origin, direction;
    Wide limit;  // in lengths of the direction: what is hit beyond does not count
    uint nodes;  // that were looked into for them
} WideRays;

// From black through red and yellow to white.
static float3 heat(const uint nodes) {
    const float share = min(3.0f * (float)nodes / HOT, 3.0f);
    return clamp(share - (float3)(0.0f, 1.0f, 2.0f), 0.0f, 1.0f);
}
// #endregion packet

// kernels/wide_render.cl
// #region trace_block
    for (int packet = 0; packet < PACKETS; ++packet) {
        rays[packet].nodes = 0;
    }
    WideHits hits[PACKETS];
    closest_hits(&scene, rays, hits);
    for (int packet = 0; packet < PACKETS; ++packet) {
        colors[packet] = wide3(heat(rays[packet].nodes));
    }
// #endregion trace_block

// kernels/bvh.cl
// #region look_into
        __global const BvhNode *node = &scene->bvh_nodes[waiting->node[bottom]];
        for (int packet = 0; packet < PACKETS; ++packet) {
            if (alone == ALL_PACKETS || packet == alone) {
                ++rays[packet].nodes;
            }
        }
// #endregion look_into
