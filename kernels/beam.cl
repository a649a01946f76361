// SPDX-License-Identifier: MIT
// Introduced by stage 09: where boxes are entered, by a ray, by a packet of rays, and by all the rays of
// a work-item together.
#include "scene.cl"
#include "wide.cl"

// #region boxes
// The boxes of a node's children, tried at once.
typedef JOIN(float, BVH_WIDTH) Boxes;
#define LOAD_BOXES(row) JOIN(TO_REAL, BVH_WIDTH)(JOIN(vload, BVH_WIDTH)(0, row))
#define STORE_BOXES(value, row) JOIN(vstore, BVH_WIDTH)(value, 0, row)

// A bit for each that the mask is set for.
static int bits_of_four(const LaneInt4 mask) {
    const LaneInt4 bits = mask & (LaneInt4)(1, 2, 4, 8);
    const LaneInt2 two = bits.lo | bits.hi;
    return two.x | two.y;
}

static int bits_of(const JOIN(LANE_INT, BVH_WIDTH) mask) {
#if BVH_WIDTH == 8
    return bits_of_four(mask.lo) | bits_of_four(mask.hi) << 4;
#elif BVH_WIDTH == 4
    return bits_of_four(mask);
#else
    return (mask.x & 1) | (mask.y & 2);
#endif
}
// #endregion boxes

// #region box_methods
// The smaller and the larger of two numbers, of any width: the second where one of them is not a number.
#define LESSER(a, b) ((a) < (b) ? (a) : (b))
#define GREATER(a, b) ((a) > (b) ? (a) : (b))

#include "box/robust.cl"
// #endregion box_methods

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

// #region slab_axis
typedef struct SlabAxis {
    Wide inverse;  // of the direction
    Wide low, high;
} SlabAxis;

typedef struct SlabRays {
    SlabAxis x, y, z;
} SlabRays;

static Wide not_too_small(const Wide direction) {
    return fabs(direction) < SMALLEST_DIRECTION ? (Wide)(SMALLEST_DIRECTION) : direction;
}

static SlabAxis slab_axis(const Wide origin, const Wide direction) {
    const Wide inverse = 1.0f / not_too_small(direction);
    const Wide room = fabs(origin) * ROOM;
    const SlabAxis axis = {inverse, -(origin + room) * inverse, -(origin - room) * inverse};
    return axis;
}
// #endregion slab_axis

static SlabRays slab_rays(const WideRays *rays) {
    const SlabRays slabs = {slab_axis(rays->origin.x, rays->direction.x),
                            slab_axis(rays->origin.y, rays->direction.y),
                            slab_axis(rays->origin.z, rays->direction.z)};
    return slabs;
}

// #region enter_box
// Which rays are in the box of one child anywhere before `limit`.
static WideInt enter_box(__global const BvhNode *node, const int child, const SlabRays *rays,
                         const Wide limit) {
    const Wide low_x = FUSED((Wide)(node->planes[0][child]), rays->x.inverse, rays->x.low);
    const Wide low_y = FUSED((Wide)(node->planes[1][child]), rays->y.inverse, rays->y.low);
    const Wide low_z = FUSED((Wide)(node->planes[2][child]), rays->z.inverse, rays->z.low);
    const Wide high_x = FUSED((Wide)(node->planes[3][child]), rays->x.inverse, rays->x.high);
    const Wide high_y = FUSED((Wide)(node->planes[4][child]), rays->y.inverse, rays->y.high);
    const Wide high_z = FUSED((Wide)(node->planes[5][child]), rays->z.inverse, rays->z.high);
    const Wide enter_xy = GREATER(LESSER(low_x, high_x), LESSER(low_y, high_y));
    const Wide leave_xy = LESSER(GREATER(low_x, high_x), GREATER(low_y, high_y));
    const Wide enter = GREATER(enter_xy, GREATER(LESSER(low_z, high_z), (Wide)(0.0f)));
    const Wide leave = LESSER(leave_xy, LESSER(GREATER(low_z, high_z), limit));
    return enter <= leave;
}
// #endregion enter_box
// #endregion slab

// #region beam
// All rays of a work-item as one thick ray: along each axis, the bounds of their origins and of their
// directions. Against that, all boxes of a node are tried at once, for little more than a single ray
// would cost.
//
// Where all rays go forwards, a box is entered through its low plane, and by none before the one that
// starts nearest to it and is fastest; it is left through its high plane, and by none after the one
// that starts farthest from it and is slowest. Each is a single p * inverse + offset. (It is another's
// turn where the plane is behind that one. But then the box is behind all, or some are in it already.)
typedef struct Bound {
    PerPacket inverse, offset;
} Bound;

typedef struct BeamAxis {
    Bound enter;       // at the plane that is met first
    Bound leave;       // at the other
    Bound enter_back;  // at the other, where not all rays go the same way
} BeamAxis;

// Along an axis: where rays start, and how fast they are, at the least and at the most.
typedef struct Extent {
    PerPacket low, high;
    PerPacket slowest, fastest;
} Extent;

typedef struct Beam {
    BeamAxis all[3];  // the same numbers for each packet
    int near_row[3], far_row[3];  // of BvhNode: the planes that are met first, and last
    int axis;  // that all rays go along, none of them nearly across it; or ALL_AXES
#if PACKETS > 1
    BeamAxis packets[3];  // each packet for itself
    Extent extents[3];    // of each
    bool is_narrow;       // all go nearly the same way
#endif
} Beam;

// A ray that is not of finite numbers, along any axis, hits nothing, and must not widen the beam of the
// others.
static WideInt counts_in_beam(const WideRays *rays) {
    WideInt counts = rays->limit > 0.0f;
    for (int axis = 0; axis < 3; ++axis) {
        counts &= fabs(along_axis(&rays->origin, axis)) + fabs(along_axis(&rays->direction, axis))
                  < INFINITY;
    }
    return counts;
}

static Extent extent_of(const WideRays *rays, const int axis) {
    Wide low[PACKETS], minus_high[PACKETS], slowest[PACKETS], minus_fastest[PACKETS];
    for (int packet = 0; packet < PACKETS; ++packet) {
        const Wide origin = along_axis(&rays[packet].origin, axis);
        const Wide direction = not_too_small(along_axis(&rays[packet].direction, axis));
        const Wide room = fabs(origin) * ROOM;
        const WideInt counts = counts_in_beam(&rays[packet]);
        low[packet] = counts ? origin - room : (Wide)(INFINITY);
        minus_high[packet] = counts ? -origin - room : (Wide)(INFINITY);
        slowest[packet] = counts ? direction : (Wide)(INFINITY);
        minus_fastest[packet] = counts ? -direction : (Wide)(INFINITY);
    }
    const Extent extent = {smallest_of_packets(low), -smallest_of_packets(minus_high),
                           smallest_of_packets(slowest), -smallest_of_packets(minus_fastest)};
    return extent;
}

static BeamAxis beam_axis(const Extent rays, const bool all_backwards) {
    const PerPacket by_fastest = 1.0f / rays.fastest;
    const PerPacket by_slowest = 1.0f / rays.slowest;
    const Bound low = {by_fastest, -rays.high * by_fastest};
    const Bound high = {by_slowest, -rays.low * by_slowest};
    const Bound none = {0.0f, -INFINITY};
    BeamAxis axis = {all_backwards ? high : low, all_backwards ? low : high, none};
#if WIDTH > 1
    if (!all_backwards) {
        axis.enter.inverse = rays.fastest > 0.0f ? low.inverse : (PerPacket)(0.0f);
        axis.enter.offset = rays.fastest > 0.0f ? low.offset : (PerPacket)(-INFINITY);
        axis.leave.inverse = rays.slowest > 0.0f ? high.inverse : (PerPacket)(0.0f);
        axis.leave.offset = rays.slowest > 0.0f ? high.offset : (PerPacket)(INFINITY);
        axis.enter_back.inverse = rays.slowest > 0.0f ? (PerPacket)(0.0f) : high.inverse;
        axis.enter_back.offset = rays.slowest > 0.0f ? (PerPacket)(-INFINITY) : high.offset;
    }
#endif
    return axis;
}

// Around all that is within the extent.
static void bound_beam(Beam *beam, const int axis, const Extent all) {
    const bool all_backwards = get_packet(all.fastest, 0) < 0.0f;
    beam->near_row[axis] = all_backwards ? axis + 3 : axis;
    beam->far_row[axis] = all_backwards ? axis : axis + 3;
    beam->all[axis] = beam_axis(all, all_backwards);
}

#define NEARLY_ACROSS 0.125f

static void beam_of(Beam *beam, const WideRays *rays) {
    float speed = 0.0f;
    float spread = 0.0f;
    float along = 0.0f;
    beam->axis = 0;
#pragma unroll
    for (int axis = 0; axis < 3; ++axis) {
        const Extent packets = extent_of(rays, axis);
        const float slowest = smallest_packet(packets.slowest);
        const float fastest = largest_packet(packets.fastest);
        speed = max(speed, max(fastest, -slowest));
        spread = max(spread, fastest - slowest);
        const float common = max(slowest, -fastest);  // all are that fast, one way or the other
        beam->axis = common > along ? axis : beam->axis;
        along = max(along, common);
        const Extent all = {smallest_packet(packets.low), largest_packet(packets.high), slowest,
                            fastest};
        bound_beam(beam, axis, all);
#if PACKETS > 1
        beam->extents[axis] = packets;
        beam->packets[axis] = beam_axis(packets, beam->near_row[axis] != axis);
#endif
    }
#if WIDTH > 1
    if (!(along >= NEARLY_ACROSS * speed)) {
        beam->axis = ALL_AXES;
    }
#endif
#if PACKETS > 1
    beam->is_narrow = spread < 0.1f * speed;
#endif
}

#if PACKETS > 1
// Of a single packet from now on.
static void narrow_beam(Beam *beam, const int packet) {
    for (int axis = 0; axis < 3; ++axis) {
        const Extent *packets = &beam->extents[axis];
        const Extent one = {get_packet(packets->low, packet), get_packet(packets->high, packet),
                            get_packet(packets->slowest, packet),
                            get_packet(packets->fastest, packet)};
        bound_beam(beam, axis, one);
    }
}
#endif
// #endregion beam

// #region enter_boxes
// Where a bound of the whole beam meets a plane of each box.
static Boxes at_planes(const Boxes planes, const Bound all) {
    return FUSED(planes, (Boxes)(get_packet(all.inverse, 0)), (Boxes)(get_packet(all.offset, 0)));
}

// #region beam_enters
// Which children's boxes the beam is in anywhere before `limit`, a bit for each, and where it enters
// them at the earliest.
static int enter_boxes(__global const BvhNode *node, const Beam *beam, const float limit,
                       Boxes *enter) {
    *enter = 0.0f;
    Boxes leave = limit;
#pragma unroll
    for (int i = 0; i < 3; ++i) {
        const BeamAxis *axis = &beam->all[i];
        const Boxes near_planes = LOAD_BOXES(node->planes[beam->near_row[i]]);
        const Boxes far_planes = LOAD_BOXES(node->planes[beam->far_row[i]]);
        const Boxes near = at_planes(near_planes, axis->enter);
        const Boxes far = at_planes(far_planes, axis->leave);
        *enter = GREATER(near, *enter);
        leave = LESSER(far, leave);
#if WIDTH > 1
        const Boxes back = at_planes(far_planes, axis->enter_back);
        *enter = GREATER(back, *enter);
#endif
    }
    return bits_of(*enter <= leave);
}
// #endregion beam_enters

// Which packets are in the box of a child anywhere before their limits, a bit for each.
static int packets_in(__global const BvhNode *node, const int child, const Beam *beam,
                      const PerPacket limits) {
#if PACKETS == 1
    return 1;  // the beam is the packet
#else
    PerPacket enter = 0.0f;
    PerPacket leave = limits;
#pragma unroll
    for (int i = 0; i < 3; ++i) {
        const BeamAxis *axis = &beam->packets[i];
        const PerPacket near_plane = node->planes[beam->near_row[i]][child];
        const PerPacket far_plane = node->planes[beam->far_row[i]][child];
        const PerPacket near = FUSED(near_plane, axis->enter.inverse, axis->enter.offset);
        const PerPacket far = FUSED(far_plane, axis->leave.inverse, axis->leave.offset);
        const PerPacket back = FUSED(far_plane, axis->enter_back.inverse, axis->enter_back.offset);
        enter = GREATER(near, enter);
        enter = GREATER(back, enter);
        leave = LESSER(far, leave);
    }
    return bits_of_four(enter <= leave);
#endif
}
// #endregion enter_boxes
