// SPDX-License-Identifier: MIT
// Introduced by stage 09: a tree of boxes, so that rays try few of the triangles, and the walk of a
// work-item's rays down it, together.
#include "beam.cl"
#include "packets/triangle/woop.cl"

// #region leaf
// The rays' limits, and `closest` where it is not 0, as walk_down has them.
static void try_leaf(const Scene *scene, WideRays *rays, const TriangleRays *shared,
                     const uint first, const uint count, WideHits *closest) {
    for (uint i = first; i < first + count; ++i) {
        Wide b, c;
        const Wide distance = wide_ray_triangle(rays, shared, scene, i, &b, &c);
        if (closest) {
            const WideInt closer =
                keep_closer(rays, closest, distance, SHAPE_TRIANGLE, (int)i);
            closest->barycentric_b = closer ? b : closest->barycentric_b;
            closest->barycentric_c = closer ? c : closest->barycentric_c;
        } else {
            block(rays, distance < rays->limit);
        }
    }
}
// #endregion leaf

// #region waiting_nodes
// The nodes that are still to be looked into, the nearest last.
typedef struct WaitingNodes {
    uint node[BVH_STACK_SIZE];
    float enter[BVH_STACK_SIZE];
    int count;
} WaitingNodes;

// #region let_wait
// Among those from `bottom` on, at its place by distance.
static void let_wait(WaitingNodes *waiting, const int bottom, const uint node, const float enter) {
    int place = waiting->count++;
    for (; place > bottom && waiting->enter[place - 1] < enter; --place) {
        waiting->node[place] = waiting->node[place - 1];
        waiting->enter[place] = waiting->enter[place - 1];
    }
    waiting->node[place] = node;
    waiting->enter[place] = enter;
}
// #endregion let_wait
// #endregion waiting_nodes

// #region walk
// All packets go down together while that pays. A beam that has come to so many nodes enters many that
// few of its rays do: then each packet goes on alone, and its rays are asked one by one.
#define NODES_TOGETHER(beam) ((beam)->is_narrow ? 32 : 8)
#define ALL_PACKETS -1

// Down from the nodes that wait, the nearer of a node's children first: what it hits may spare the
// others. With `closest`, to what each ray hits first, whose distance becomes its limit. Without, to
// whether it hits anything: then it loses its limit.
static void walk_down(const Scene *scene, WideRays *rays, const TriangleRays *shared,
                      WideHits *closest, const Beam *beam, const int alone,
                      WaitingNodes *waiting) {
    PerPacket limits = -1.0f;
    for (int packet = 0; packet < PACKETS; ++packet) {
        if (alone == ALL_PACKETS || packet == alone) {
            set_packet(&limits, packet, largest_lane(rays[packet].limit));
        }
    }
    float limit = largest_packet(limits);
#if PACKETS > 1
    SlabRays slabs;
    if (alone != ALL_PACKETS) {
        slabs = slab_rays(&rays[alone]);
    }
    int nodes_left = alone == ALL_PACKETS ? NODES_TOGETHER(beam) : INT_MAX;
#endif
    // #region walk_loop
    while (waiting->count > 0) {
#if PACKETS > 1
        if (nodes_left-- == 0) {
            return;
        }
#endif
        const int bottom = --waiting->count;
        if (waiting->enter[bottom] >= limit) {
            continue;  // all rays have hit something before it
        }
        // #region look_into
        __global const BvhNode *node = &scene->bvh_nodes[waiting->node[bottom]];
        // #endregion look_into
        Boxes enter;
        float enters[BVH_WIDTH];
        int found = enter_boxes(node, beam, limit, &enter);
        STORE_BOXES(enter, enters);
        for (int child = 0; found; ++child, found >>= 1) {
            if (!(found & 1)) {
                continue;
            }
#if PACKETS == 1
            int in = 1;  // the beam is the ray
#else
            int in = alone == ALL_PACKETS ? packets_in(node, child, beam, limits)
                     : any_lane(enter_box(node, child, &slabs, rays[alone].limit)) ? 1 << alone
                                                                                   : 0;
#endif
            if (in && node->count[child] == 0) {
                let_wait(waiting, closest ? bottom : waiting->count, node->first[child],
                         enters[child]);
                continue;
            }
            for (int packet = 0; in; ++packet, in >>= 1) {
                if (in & 1) {
                    try_leaf(scene, &rays[packet], &shared[packet], node->first[child], node->count[child],
                             closest ? &closest[packet] : 0);
                    set_packet(&limits, packet, largest_lane(rays[packet].limit));
                }
            }
            limit = largest_packet(limits);
        }
    }
    // #endregion walk_loop
}

static void walk(const Scene *scene, WideRays *rays, WideHits *closest) {
    Beam beam;
    beam_of(&beam, rays);
    TriangleRays shared[PACKETS];
    for (int packet = 0; packet < PACKETS; ++packet) {
        shared[packet] = triangle_rays(&rays[packet], beam.axis);
    }
    WaitingNodes waiting;
    waiting.count = 0;
    let_wait(&waiting, 0, 0, 0.0f);
    walk_down(scene, rays, shared, closest, &beam, ALL_PACKETS, &waiting);
#if PACKETS > 1
    for (int packet = 0; packet < PACKETS && waiting.count > 0; ++packet) {
        if (largest_lane(rays[packet].limit) > 0.0f) {
            WaitingNodes of_packet = waiting;
            narrow_beam(&beam, packet);
            walk_down(scene, rays, shared, closest, &beam, packet, &of_packet);
        }
    }
#endif
}

// A ray's limit becomes the distance of the triangle that it hits first.
static void closest_triangle(const Scene *scene, WideRays *rays, WideHits *closest) {
    walk(scene, rays, closest);
}

// A ray that has a triangle in its way loses its limit: nothing else that it meets matters.
static void block_triangles(const Scene *scene, WideRays *rays) {
    walk(scene, rays, 0);
}
// #endregion walk
