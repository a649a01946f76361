// SPDX-License-Identifier: MIT
// Introduced by stage 10: where boxes are entered by all the rays of a work-item together.
#include "packets/box.cl"

// #region boxes
// A bit for each that the mask is set for.
static int bits_of(const LaneInt4 mask) {
    const LaneInt4 bits = mask & (LaneInt4)(1, 2, 4, 8);
    const LaneInt2 two = bits.lo | bits.hi;
    return two.x | two.y;
}
// #endregion boxes

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
    BeamAxis all[3];              // the same numbers for each packet
    int near_row[3], far_row[3];  // of BvhNode: the planes that are met first, and last
    int axis;                     // that all rays go along, none of them nearly across it; or ALL_AXES
    BeamAxis packets[3];          // each packet for itself
    bool is_narrow;               // all go nearly the same way
} Beam;

// A ray that is not of finite numbers, along any axis, hits nothing, and must not widen the beam of the
// others.
static WideInt counts_in_beam(const WideRays *rays) {
    WideInt counts = rays->t_max > 0.0f;
    for (int axis = 0; axis < 3; ++axis) {
        counts &= fabs(along_axis(&rays->origin, axis)) + fabs(along_axis(&rays->direction, axis)) < INFINITY;
    }
    return counts;
}

static Extent extent_of(const WideRays *rays, const int axis) {
    Wide low[PACKETS], minus_high[PACKETS], slowest[PACKETS], minus_fastest[PACKETS];
    for (int packet = 0; packet < PACKETS; ++packet) {
        const Wide origin = along_axis(&rays[packet].origin, axis);
        const Wide direction = not_too_small(along_axis(&rays[packet].direction, axis));
        const Wide padding = fabs(origin) * PADDING;
        const WideInt counts = counts_in_beam(&rays[packet]);
        low[packet] = counts ? origin - padding : (Wide)(INFINITY);
        minus_high[packet] = counts ? -origin - padding : (Wide)(INFINITY);
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
    if (!all_backwards) {
        axis.enter.inverse = rays.fastest > 0.0f ? low.inverse : (PerPacket)(0.0f);
        axis.enter.offset = rays.fastest > 0.0f ? low.offset : (PerPacket)(-INFINITY);
        axis.leave.inverse = rays.slowest > 0.0f ? high.inverse : (PerPacket)(0.0f);
        axis.leave.offset = rays.slowest > 0.0f ? high.offset : (PerPacket)(INFINITY);
        axis.enter_back.inverse = rays.slowest > 0.0f ? (PerPacket)(0.0f) : high.inverse;
        axis.enter_back.offset = rays.slowest > 0.0f ? (PerPacket)(-INFINITY) : high.offset;
    }
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
        const Extent all = {smallest_packet(packets.low), largest_packet(packets.high), slowest, fastest};
        bound_beam(beam, axis, all);
        beam->packets[axis] = beam_axis(packets, beam->near_row[axis] != axis);
    }
    if (!(along >= NEARLY_ACROSS * speed)) {
        beam->axis = ALL_AXES;
    }
    beam->is_narrow = spread < 0.1f * speed;
}
// #endregion beam

// #region enter_boxes
// Where a bound of the whole beam meets a plane of each box.
static float4 at_planes(const float4 planes, const Bound all) {
    return FUSED(planes, (float4)(get_packet(all.inverse, 0)), (float4)(get_packet(all.offset, 0)));
}

// #region beam_enters
// Which children's boxes the beam is in anywhere before `t_max`, a bit for each, and where it enters
// them at the earliest.
static int enter_boxes(__global const BvhNode *node, const Beam *beam, const float t_max, float *enters) {
    float4 enter = 0.0f;
    float4 leave = t_max;
#pragma unroll
    for (int i = 0; i < 3; ++i) {
        const BeamAxis *axis = &beam->all[i];
        const float4 near_planes = XYZW(node->planes[beam->near_row[i]]);
        const float4 far_planes = XYZW(node->planes[beam->far_row[i]]);
        const float4 near = at_planes(near_planes, axis->enter);
        const float4 far = at_planes(far_planes, axis->leave);
        enter = MAX(near, enter);
        leave = MIN(far, leave);
        const float4 back = at_planes(far_planes, axis->enter_back);
        enter = MAX(back, enter);
    }
    vstore4(enter, 0, enters);
    return bits_of(enter <= leave);
}
// #endregion beam_enters

// Which packets are in the box of a child anywhere before their t_max, a bit for each.
static int packets_in(__global const BvhNode *node, const int child, const Beam *beam,
                      const PerPacket t_max_each) {
    PerPacket enter = 0.0f;
    PerPacket leave = t_max_each;
#pragma unroll
    for (int i = 0; i < 3; ++i) {
        const BeamAxis *axis = &beam->packets[i];
        const PerPacket near_plane = plane_of(node, beam->near_row[i], child);
        const PerPacket far_plane = plane_of(node, beam->far_row[i], child);
        const PerPacket near = FUSED(near_plane, axis->enter.inverse, axis->enter.offset);
        const PerPacket far = FUSED(far_plane, axis->leave.inverse, axis->leave.offset);
        const PerPacket back = FUSED(far_plane, axis->enter_back.inverse, axis->enter_back.offset);
        enter = MAX(near, enter);
        enter = MAX(back, enter);
        leave = MIN(far, leave);
    }
    return bits_of(enter <= leave);
}
// #endregion enter_boxes
