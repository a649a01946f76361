// SPDX-License-Identifier: MIT
// Introduced by stage 10: the walk of a packet down the tree of boxes.
#include "cutout.cl"
#include "packets/box.cl"
#include "packets/sphere.cl"
#include "packets/triangle/woop.cl"

// #region leaf
// The rays' t_max, and `closest` where it is not 0, as walk_packet has them.
static void try_spheres(const Scene *scene, WideRays *rays, const bool are_lines, const int first, const int count,
                        WideHits *closest) {
    for (int i = first; i < first + count; ++i) {
        const float3 center = XYZ(scene->spheres[i].center);
        const float radius = scene->spheres[i].radius;
        if (are_lines) {
            block(rays, wide_line_sphere(rays, center, radius));
        } else if (closest) {
            wide_keep_closer(rays, closest, wide_ray_sphere(rays, center, radius), SHAPE_SPHERE, i);
        } else {
            block(rays, wide_ray_sphere(rays, center, radius) < INFINITY);
        }
    }
}

// Lane by lane, where a ray would be stopped: INFINITY where the triangle is not there.
static Wide uncut(const Scene *scene, const WideRays *rays, const int index, const Wide distance, const Wide b,
                  const Wide c) {
    const WideInt stops = distance < rays->t_max;
    if (scene->cutouts[scene->triangles[index].material].cutoff == 0.0f || !any_lane(stops)) {
        return distance;
    }
    const LanesInt stop_lanes = {.wide = stops};
    const Lanes b_lanes = {.wide = b}, c_lanes = {.wide = c};
    Lanes distances = {.wide = distance};
    for (int lane = 0; lane < WIDTH; ++lane) {
        if (stop_lanes.lane[lane] && is_cut_out(scene, index, (float2)(b_lanes.lane[lane], c_lanes.lane[lane]))) {
            distances.lane[lane] = INFINITY;
        }
    }
    return distances.wide;
}

static void try_triangles(const Scene *scene, WideRays *rays, const TriangleRays *shared, const int first,
                          const int count, WideHits *closest) {
    for (int i = first; i < first + count; ++i) {
        Wide b, c;
        Wide distance = wide_ray_triangle(rays, shared, scene, i, &b, &c);
        if (HAS_CUTOUTS) {
            distance = uncut(scene, rays, i, distance, b, c);
        }
        if (closest) {
            const WideInt closer = wide_keep_closer(rays, closest, distance, SHAPE_TRIANGLE, i);
            closest->barycentric_b = closer ? b : closest->barycentric_b;
            closest->barycentric_c = closer ? c : closest->barycentric_c;
        } else {
            block(rays, distance < rays->t_max);
        }
    }
}

static void try_leaf(const Scene *scene, WideRays *rays, const bool are_lines, const TriangleRays *shared,
                     const int first, const int count, WideHits *closest) {
    if (HAS_SPHERES && (!HAS_TRIANGLES || count < 0)) {
        try_spheres(scene, rays, are_lines, first, -count, closest);
    } else if (HAS_TRIANGLES) {
        try_triangles(scene, rays, shared, first, count, closest);
    }
}
// #endregion leaf

// #region traversal_stack
// The nodes that are still to be looked into, the nearest last.
typedef struct TraversalStack {
    int node[BVH_STACK_SIZE];
    float enter[BVH_STACK_SIZE];
    int count;
} TraversalStack;

// Keeps the nodes from `bottom` on sorted by distance: nearer ones move up to make room.
static void push_node(TraversalStack *stack, const int bottom, const int node, const float enter) {
    int place = stack->count++;
    for (; place > bottom && stack->enter[place - 1] < enter; --place) {
        stack->node[place] = stack->node[place - 1];
        stack->enter[place] = stack->enter[place - 1];
    }
    stack->node[place] = node;
    stack->enter[place] = enter;
}
// #endregion traversal_stack

// #region walk_packet
// Down from the nodes that are pending, the nearest first: what its rays hit may spare them the others. A box is
// looked into where any of them enters it. With `closest`, to what each ray hits first, whose distance becomes its
// t_max. Without, to whether it hits anything: then it loses its t_max.
static void walk_packet(const Scene *scene, WideRays *rays, const bool are_lines, const TriangleRays *shared,
                        WideHits *closest, TraversalStack *stack) {
    const SlabRays slabs = slab_rays(rays);
    float t_max = largest_lane(rays->t_max);
    while (stack->count > 0) {
        const int bottom = --stack->count;
        if (stack->enter[bottom] >= t_max) {
            continue;  // all rays have hit something before it
        }
        // #region look_into
        __global const BvhNode *node = &scene->bvh_nodes[stack->node[bottom]];
        // #endregion look_into
        for (int child = 0; child < 4; ++child) {
            const float nearest = smallest_lane(enter_box(node, child, &slabs, rays->t_max));
            if (nearest == NOT_ENTERED) {
                continue;
            }
            if (node->count[child] == 0) {
                push_node(stack, closest ? bottom : stack->count, node->first[child], nearest);
            } else {
                try_leaf(scene, rays, are_lines, shared, node->first[child], node->count[child], closest);
                t_max = largest_lane(rays->t_max);
            }
        }
    }
}
// #endregion walk_packet
