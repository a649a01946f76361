// SPDX-License-Identifier: MIT
// How the packets of a work-item go down the tree: each by itself (Wald et al., Interactive Rendering with
// Coherent Ray Tracing, 2001).
#include "packets/walk.cl"

static void walk(const Scene *scene, WideRays *rays, const bool are_lines, WideHits *closest) {
    for (int packet = 0; packet < PACKETS; ++packet) {
        if (largest_lane(rays[packet].t_max) > 0.0f) {
            const TriangleRays shared = triangle_rays(&rays[packet], ALL_AXES);
            TraversalStack stack;
            stack.count = 0;
            push_node(&stack, 0, 0, 0.0f);
            walk_packet(scene, &rays[packet], are_lines, &shared, closest ? &closest[packet] : 0, &stack);
        }
    }
}
