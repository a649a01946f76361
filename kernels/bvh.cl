// SPDX-License-Identifier: MIT
// Introduced by stage 09: a tree of boxes, so that rays try few of the triangles, and the walk of
// WIDTH rays down it, side by side.
#include "scene.cl"
#include "wide.cl"

// #region boxes
// The boxes of a node's children, tried at once.
typedef JOIN(float, BVH_WIDTH) Boxes;
#define LOAD_BOXES(row) JOIN(vload, BVH_WIDTH)(0, row)
#define STORE_BOXES(value, row) JOIN(vstore, BVH_WIDTH)(value, 0, row)

// A bit for each child that the mask is set for.
static int bits_of(const JOIN(int, BVH_WIDTH) mask) {
#if BVH_WIDTH == 8
    const int8 bits = mask & (int8)(1, 2, 4, 8, 16, 32, 64, 128);
    const int4 four = bits.lo | bits.hi;
    const int2 two = four.lo | four.hi;
#elif BVH_WIDTH == 4
    const int4 bits = mask & (int4)(1, 2, 4, 8);
    const int2 two = bits.lo | bits.hi;
#else
    const int2 two = mask & (int2)(1, 2);
#endif
    return two.x | two.y;
}
// #endregion boxes

// #region slab
// A box is where three slabs meet (Kay and Kajiya, Ray Tracing Complex Scenes, 1986). This is what a
// ray's tests against all slabs of an axis have in common: the plane at p is met at the distance
// p * inverse + low, or + high; between the two lies what rounding can do.
//
// Rounding moves a plane by some units in the last place of the two coordinates that it is measured
// between. For where the box is, its makers left room (common/device/bvh.cpp); here is the room for
// where the ray is. With it, a direction of 0 may be taken for the smallest that counts: a ray in the
// plane of a side stays inside. Every choice between two numbers below keeps the box where one of
// them is not a number.
#define SMALLEST_DIRECTION 1e-24f

typedef struct SlabAxis {
    Wide inverse;  // of the direction
    Wide low, high;
} SlabAxis;

typedef struct SlabRays {
    SlabAxis x, y, z;
} SlabRays;

static SlabAxis slab_axis(const Wide origin, const Wide direction) {
    const WideInt is_small = fabs(direction) < SMALLEST_DIRECTION;
    const Wide inverse = 1.0f / (is_small ? (Wide)(SMALLEST_DIRECTION) : direction);
    const Wide room = fabs(origin) * SLAB_ROOM;
    const SlabAxis axis = {inverse, -(origin + room) * inverse, -(origin - room) * inverse};
    return axis;
}

static SlabRays slab_rays(const WideRays *rays) {
    const SlabRays slabs = {slab_axis(rays->origin.x, rays->direction.x),
                            slab_axis(rays->origin.y, rays->direction.y),
                            slab_axis(rays->origin.z, rays->direction.z)};
    return slabs;
}

// Which rays are in the box of one child anywhere before `limit`.
static WideInt enter_box(__global const BvhNode *node, const int child, const SlabRays *rays,
                         const Wide limit) {
    const Wide low_x = fma((Wide)(node->planes[0][child]), rays->x.inverse, rays->x.low);
    const Wide low_y = fma((Wide)(node->planes[1][child]), rays->y.inverse, rays->y.low);
    const Wide low_z = fma((Wide)(node->planes[2][child]), rays->z.inverse, rays->z.low);
    const Wide high_x = fma((Wide)(node->planes[3][child]), rays->x.inverse, rays->x.high);
    const Wide high_y = fma((Wide)(node->planes[4][child]), rays->y.inverse, rays->y.high);
    const Wide high_z = fma((Wide)(node->planes[5][child]), rays->z.inverse, rays->z.high);
    const Wide enter = larger(larger(smaller(low_x, high_x), smaller(low_y, high_y)),
                              larger(smaller(low_z, high_z), (Wide)(0.0f)));
    const Wide leave = smaller(smaller(larger(low_x, high_x), larger(low_y, high_y)),
                               smaller(larger(low_z, high_z), limit));
    return enter < leave;
}
// #endregion slab

// #region beam
// All rays of a work-item as one thick ray: along each axis, the bounds of their origins and of the
// inverses of their directions. Against that, all boxes of a node are tried at once, for little more
// than a single ray would cost. Over the beam, the plane at p is met nowhere before the smaller of
// p * inverse[0] + near[0] and p * inverse[1] + near[1], and nowhere after the larger of those with far.
typedef struct BeamAxis {
    float inverse[2];
    float near[2], far[2];
    int near_row, far_row;  // of BvhNode: the planes that are met first, and last
} BeamAxis;

typedef struct Beam {
    BeamAxis axes[3];
} Beam;

// Rays that do not all go the same way along an axis are not bounded by its planes. A ray that is not
// a number hits nothing, and must not widen or narrow the beam of the others.
static BeamAxis beam_axis(const SlabAxis *slabs, const Wide origin, const WideInt there,
                          const int row) {
    const WideInt counts = there & (slabs->low == slabs->low) & (slabs->high == slabs->high);
    const Wide room = fabs(origin) * SLAB_ROOM;
    const float low = smallest_lane(counts ? origin - room : (Wide)(INFINITY));
    const float high = largest_lane(counts ? origin + room : (Wide)(-INFINITY));
    const float inverse_low = smallest_lane(counts ? slabs->inverse : (Wide)(INFINITY));
    const float inverse_high = largest_lane(counts ? slabs->inverse : (Wide)(-INFINITY));
    const bool forwards = inverse_low > 0.0f;
    if (!forwards && !(inverse_high < 0.0f)) {
        const BeamAxis unbounded = {
            {0.0f, 0.0f}, {-INFINITY, -INFINITY}, {INFINITY, INFINITY}, row, row};
        return unbounded;
    }
    const float from_near = forwards ? high : low;
    const float from_far = forwards ? low : high;
    const BeamAxis axis = {{inverse_low, inverse_high},
                           {-from_near * inverse_low, -from_near * inverse_high},
                           {-from_far * inverse_low, -from_far * inverse_high},
                           forwards ? row : row + 3,
                           forwards ? row + 3 : row};
    return axis;
}

static Beam beam_of(const WideRays *rays, const SlabRays *slabs) {
    const WideInt there = rays->limit > 0.0f;
    const Beam beam = {{beam_axis(&slabs->x, rays->origin.x, there, 0),
                        beam_axis(&slabs->y, rays->origin.y, there, 1),
                        beam_axis(&slabs->z, rays->origin.z, there, 2)}};
    return beam;
}
// #endregion beam

// #region enter_boxes
static Boxes enter_slabs(__global const BvhNode *node, const BeamAxis *axis) {
    const Boxes planes = LOAD_BOXES(node->planes[axis->near_row]);
    const Boxes a = fma(planes, (Boxes)(axis->inverse[0]), (Boxes)(axis->near[0]));
#if WIDTH == 1
    return a;
#else
    const Boxes b = fma(planes, (Boxes)(axis->inverse[1]), (Boxes)(axis->near[1]));
    return a < b ? a : b;
#endif
}

static Boxes leave_slabs(__global const BvhNode *node, const BeamAxis *axis) {
    const Boxes planes = LOAD_BOXES(node->planes[axis->far_row]);
    const Boxes a = fma(planes, (Boxes)(axis->inverse[0]), (Boxes)(axis->far[0]));
#if WIDTH == 1
    return a;
#else
    const Boxes b = fma(planes, (Boxes)(axis->inverse[1]), (Boxes)(axis->far[1]));
    return a > b ? a : b;
#endif
}

// Which children's boxes the beam is in anywhere before `limit`, a bit for each, and where it enters
// them at the earliest.
static int enter_boxes(__global const BvhNode *node, const Beam *beam, const float limit,
                       Boxes *enter) {
    *enter = 0.0f;
    Boxes leave = limit;
    for (int axis = 0; axis < 3; ++axis) {
        const Boxes near = enter_slabs(node, &beam->axes[axis]);
        const Boxes far = leave_slabs(node, &beam->axes[axis]);
        *enter = near > *enter ? near : *enter;
        leave = far < leave ? far : leave;
    }
    return bits_of(*enter < leave);
}

// Those of them that a ray of its own is in as well.
static bool any_enters(__global const BvhNode *node, const int child, const SlabRays *rays,
                       const Wide limit) {
#if WIDTH == 1
    return true;  // the beam is the ray
#else
    return any_lane(enter_box(node, child, rays, limit));
#endif
}
// #endregion enter_boxes

// #region facets
// Möller and Trumbore's test (triangle.cl), with the edges worked out beforehand. INFINITY for a miss;
// every comparison is false for a NaN, which a determinant of 0 makes.
static Wide intersect_facet(const WideRays *rays, __global const Facet *facet, Wide *b, Wide *c) {
    const Wide3 edge_b = wide3(vload3(0, facet->edge_b));
    const Wide3 edge_c = wide3(vload3(0, facet->edge_c));
    const Wide3 p = wide_cross(rays->direction, edge_c);
    const Wide inverse = 1.0f / wide_dot(edge_b, p);
    const Wide3 to_origin = wide_difference(rays->origin, wide3(vload3(0, facet->corner)));
    const Wide3 q = wide_cross(to_origin, edge_b);
    *b = wide_dot(to_origin, p) * inverse;
    *c = wide_dot(rays->direction, q) * inverse;
    const Wide t = wide_dot(edge_c, q) * inverse;
    const WideInt hits = (*b >= 0.0f) & (*c >= 0.0f) & (*b + *c <= 1.0f) & (t > 0.0f);
    return hits ? t : (Wide)(INFINITY);
}

static void closest_in_leaf(const Scene *scene, const WideRays *rays, const uint first,
                            const uint count, WideHits *closest) {
    for (uint i = first; i < first + count; ++i) {
        Wide b, c;
        const Wide distance = intersect_facet(rays, &scene->facets[i], &b, &c);
        const WideInt closer = distance < closest->distance;
        closest->distance = closer ? distance : closest->distance;
        closest->shape = closer ? (WideInt)(SHAPE_TRIANGLE) : closest->shape;
        closest->index = closer ? (WideInt)(i) : closest->index;
        closest->barycentric_b = closer ? b : closest->barycentric_b;
        closest->barycentric_c = closer ? c : closest->barycentric_c;
    }
}

static void block_in_leaf(const Scene *scene, WideRays *rays, const uint first, const uint count) {
    for (uint i = first; i < first + count; ++i) {
        Wide b, c;
        const Wide t = intersect_facet(rays, &scene->facets[i], &b, &c);
        rays->limit = t < rays->limit ? (Wide)(-1.0f) : rays->limit;
    }
}
// #endregion facets

// #region closest_triangle
// The nodes that are still to be looked into, the nearest last.
typedef struct WaitingNodes {
    uint node[BVH_STACK_SIZE];
    float enter[BVH_STACK_SIZE];
    int count;
} WaitingNodes;

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

// The nearer of a node's children first: what it hits may spare the others.
static void closest_triangle(const Scene *scene, const WideRays *rays, WideHits *closest) {
    const SlabRays slabs = slab_rays(rays);
    const Beam beam = beam_of(rays, &slabs);
    float limit = largest_lane(closest->distance);
    WaitingNodes waiting;
    waiting.count = 0;
    let_wait(&waiting, 0, 0, 0.0f);
    while (waiting.count > 0) {
        --waiting.count;
        if (waiting.enter[waiting.count] >= limit) {
            continue;  // all rays have hit something before it
        }
        __global const BvhNode *node = &scene->bvh_nodes[waiting.node[waiting.count]];
        const int bottom = waiting.count;
        Boxes enter;
        float enters[BVH_WIDTH];
        int found = enter_boxes(node, &beam, limit, &enter);
        STORE_BOXES(enter, enters);
        for (int child = 0; found; ++child, found >>= 1) {
            if (!(found & 1) || !any_enters(node, child, &slabs, closest->distance)) {
                continue;
            }
            if (node->count[child] == 0) {
                let_wait(&waiting, bottom, node->first[child], enters[child]);
            } else {
                closest_in_leaf(scene, rays, node->first[child], node->count[child], closest);
                limit = largest_lane(closest->distance);
            }
        }
    }
}
// #endregion closest_triangle

// #region block_triangles
// The rays that have a triangle in their way lose their limit: nothing else that they meet matters.
static void block_triangles(const Scene *scene, WideRays *rays) {
    const SlabRays slabs = slab_rays(rays);
    const Beam beam = beam_of(rays, &slabs);
    float limit = largest_lane(rays->limit);
    uint waiting[BVH_STACK_SIZE];
    int count = 1;
    waiting[0] = 0;
    while (count > 0 && limit > 0.0f) {
        __global const BvhNode *node = &scene->bvh_nodes[waiting[--count]];
        Boxes enter;
        int found = enter_boxes(node, &beam, limit, &enter);
        for (int child = 0; found; ++child, found >>= 1) {
            if (!(found & 1) || !any_enters(node, child, &slabs, rays->limit)) {
                continue;
            }
            if (node->count[child] == 0) {
                waiting[count++] = node->first[child];
            } else {
                block_in_leaf(scene, rays, node->first[child], node->count[child]);
                limit = largest_lane(rays->limit);
            }
        }
    }
}
// #endregion block_triangles
