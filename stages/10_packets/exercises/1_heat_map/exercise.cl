// SPDX-License-Identifier: MIT
// #stub
// Exercise 10.1: how many nodes of the tree were looked into for each pixel.
// #solution
// Exercise 10.1, solved: a node counts for each packet that it is looked into for.
// #end

// kernels/packets/wide.cl
// #region packet
#define HOT 64

// A packet of rays. A lane without a ray has a t_max below 0, and hits nothing.
typedef struct WideRays {
    Wide3 origin, direction;
    Wide t_max;  // in lengths of the direction: what is hit beyond does not count
    uint nodes;  // that were looked into for them
} WideRays;

// From black through red and yellow to white.
static float3 heat(const uint nodes) {
    const float share = min(3.0f * (float)nodes / HOT, 3.0f);
    return clamp(share - (float3)(0.0f, 1.0f, 2.0f), 0.0f, 1.0f);
}
// #endregion packet

// kernels/packets/render.cl
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

// kernels/packets/walk.cl
// #region look_into
        __global const BvhNode *node = &scene->bvh_nodes[stack->node[bottom]];
// #stub
        // your turn
// #solution
        ++rays->nodes;
// #end
// #endregion look_into

// kernels/packets/walk/beam.cl
// #region look_into_together
        __global const BvhNode *node = &scene->bvh_nodes[stack->node[bottom]];
// #stub
        // your turn
// #solution
        for (int packet = 0; packet < PACKETS; ++packet) {
            ++rays[packet].nodes;
        }
// #end
// #endregion look_into_together
