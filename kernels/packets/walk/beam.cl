// SPDX-License-Identifier: MIT
// Introduced by stage 10: how the packets of a work-item go down the tree: together as one beam, while that pays.
#include "packets/beam.cl"
#include "packets/walk.cl"

// #region walk_beam
// A beam that has come to so many nodes enters many that few of its rays do.
#define NODES_TOGETHER(beam) ((beam)->is_narrow ? 32 : 8)

// As walk_packet, of all packets. Which of them enter a leaf is asked for each packet, of its own bounds.
static void walk_beam(const Scene *scene, WideRays *rays, const bool are_lines, const TriangleRays *shared,
                      WideHits *closest, const Beam *beam, TraversalStack *stack) {
    PerPacket t_max_each = -1.0f;
    for (int packet = 0; packet < PACKETS; ++packet) {
        set_packet(&t_max_each, packet, largest_lane(rays[packet].t_max));
    }
    float t_max = largest_packet(t_max_each);
    for (int left = NODES_TOGETHER(beam); left > 0 && stack->count > 0; --left) {
        const int bottom = --stack->count;
        if (stack->enter[bottom] >= t_max) {
            continue;  // all rays have hit something before it
        }
        // #region look_into_together
        __global const BvhNode *node = &scene->bvh_nodes[stack->node[bottom]];
        // #endregion look_into_together
        float enters[4];
        int found = enter_boxes(node, beam, t_max, enters);
        for (int child = 0; found; ++child, found >>= 1) {
            int in = found & 1 ? packets_in(node, child, beam, t_max_each) : 0;
            if (in && node->count[child] == 0) {
                push_node(stack, closest ? bottom : stack->count, node->first[child], enters[child]);
                continue;
            }
            for (int packet = 0; in; ++packet, in >>= 1) {
                if (in & 1) {
                    try_leaf(scene, &rays[packet], are_lines, &shared[packet], node->first[child],
                             node->count[child], closest ? &closest[packet] : 0);
                    set_packet(&t_max_each, packet, largest_lane(rays[packet].t_max));
                }
            }
            t_max = largest_packet(t_max_each);
        }
    }
}
// #endregion walk_beam

// #region walk
// Each packet goes on alone from the nodes that the beam has left.
static void walk(const Scene *scene, WideRays *rays, const bool are_lines, WideHits *closest) {
    Beam beam;
    beam_of(&beam, rays);
    TriangleRays shared[PACKETS];
    for (int packet = 0; HAS_TRIANGLES && packet < PACKETS; ++packet) {
        shared[packet] = triangle_rays(&rays[packet], beam.axis);
    }
    TraversalStack stack;
    stack.count = 0;
    push_node(&stack, 0, 0, 0.0f);
    walk_beam(scene, rays, are_lines, shared, closest, &beam, &stack);
    for (int packet = 0; packet < PACKETS && stack.count > 0; ++packet) {
        if (largest_lane(rays[packet].t_max) > 0.0f) {
            TraversalStack of_packet = stack;
            walk_packet(scene, &rays[packet], are_lines, &shared[packet], closest ? &closest[packet] : 0,
                        &of_packet);
        }
    }
}
// #endregion walk
