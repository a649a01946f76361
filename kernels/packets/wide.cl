// SPDX-License-Identifier: MIT
// Introduced by stage 10: numbers for WIDTH rays at a time, a lane for each. A GPU puts work-items
// side by side by itself, and draws with the kernel of stage 09. A CPU's vector unit is given 4, 8 or
// 16 numbers at once by a work-item that traces four such packets of rays.
#include "ray.cl"

// #region wide
// A mask is what comparing two Wide gives: in a lane it is 0, or else -1 (all bits).
typedef JOIN(float, WIDTH) Wide;
typedef JOIN(LANE_INT, WIDTH) WideInt;
typedef JOIN(LANE_INT, 4) LaneInt4;
typedef JOIN(LANE_INT, 2) LaneInt2;

// In memory, where each lane can be reached. Not by vload and vstore, which PoCL does in pieces: what
// is stored in small pieces and loaded in large ones has to wait for the cache.
typedef union Lanes {
    Wide wide;
    float lane[WIDTH];
} Lanes;

typedef union LanesInt {
    WideInt wide;
    LANE_INT lane[WIDTH];
} LanesInt;

// The pixels of a packet are close together so that its rays are too: a tile of them, and where each
// lane's is from the upper left one. So are the packets of a work-item, two beside and two below.
#define TILE_WIDTH TILE_WIDTH_OF(WIDTH)
#define TILE_HEIGHT (WIDTH / TILE_WIDTH)
#define PACKETS (PACKETS_IN_ROW * PACKETS_IN_ROW)
#if WIDTH == 4
#define LANE_X (Wide)(0.0f, 1.0f, 0.0f, 1.0f)
#define LANE_Y (Wide)(0.0f, 0.0f, 1.0f, 1.0f)
#elif WIDTH == 8
#define LANE_X (Wide)(0.0f, 1.0f, 2.0f, 3.0f, 0.0f, 1.0f, 2.0f, 3.0f)
#define LANE_Y (Wide)((float4)(0.0f), (float4)(1.0f))
#elif WIDTH == 16
#define FOUR_LANES_X (float4)(0.0f, 1.0f, 2.0f, 3.0f)
#define LANE_X (Wide)(FOUR_LANES_X, FOUR_LANES_X, FOUR_LANES_X, FOUR_LANES_X)
#define LANE_Y (Wide)((float4)(0.0f), (float4)(1.0f), (float4)(2.0f), (float4)(3.0f))
#endif
// #endregion wide

// #region lanes
// What is left of all lanes when they are combined until there are four.
#if WIDTH == 16
#define FOUR_OF(lanes, COMBINE) \
    COMBINE(COMBINE((lanes).lo.lo, (lanes).lo.hi), COMBINE((lanes).hi.lo, (lanes).hi.hi))
#elif WIDTH == 8
#define FOUR_OF(lanes, COMBINE) COMBINE((lanes).lo, (lanes).hi)
#else
#define FOUR_OF(lanes, COMBINE) (lanes)
#endif
#define EITHER(a, b) ((a) | (b))
#define SUM(a, b) ((a) + (b))

// Whether a mask is set in any lane. PoCL's any() is several times slower.
static bool any_lane(const WideInt mask) {
    const LaneInt4 four = FOUR_OF(mask, EITHER);
    const LaneInt2 two = four.lo | four.hi;
    return two.x | two.y;
}

static int sum_of_lanes(const WideInt numbers) {
    const LaneInt4 four = FOUR_OF(numbers, SUM);
    const LaneInt2 two = four.lo + four.hi;
    return two.x + two.y;
}

// Of numbers only: no NaN.
static float smallest_of_four(const float4 numbers) {
    const float2 two = MIN(numbers.lo, numbers.hi);
    return MIN(two.x, two.y);
}

static float smallest_lane(const Wide lanes) {
    return smallest_of_four(FOUR_OF(lanes, MIN));
}

static float largest_lane(const Wide lanes) {
    return -smallest_lane(-lanes);
}
// #endregion lanes

// #region packets
// A number for each packet of a work-item.
typedef float4 PerPacket;

// The smallest lane of each packet.
static PerPacket smallest_of_packets(const Wide *packets) {
    const float4 a = FOUR_OF(packets[0], MIN);
    const float4 b = FOUR_OF(packets[1], MIN);
    const float4 c = FOUR_OF(packets[2], MIN);
    const float4 d = FOUR_OF(packets[3], MIN);
    const float4 ab = MIN((float4)(a.lo, b.lo), (float4)(a.hi, b.hi));
    const float4 cd = MIN((float4)(c.lo, d.lo), (float4)(c.hi, d.hi));
    return MIN((float4)(ab.even, cd.even), (float4)(ab.odd, cd.odd));
}

static float smallest_packet(const PerPacket packets) {
    return smallest_of_four(packets);
}

static float largest_packet(const PerPacket packets) {
    return -smallest_packet(-packets);
}

static float get_packet(const PerPacket packets, const int packet) {
    return packet == 0 ? packets.x : packet == 1 ? packets.y : packet == 2 ? packets.z : packets.w;
}

static void set_packet(PerPacket *packets, const int packet, const float value) {
    *packets = (LaneInt4)(0, 1, 2, 3) == packet ? (float4)(value) : *packets;
}
// #endregion packets

// #region wide3
// A vector for each ray: to calculate with, and in memory, where each lane can be reached.
typedef struct Wide3 {
    Wide x, y, z;
} Wide3;

typedef struct Lanes3 {
    Lanes x, y, z;
} Lanes3;

static void put_lane(Lanes3 *lanes, const int lane, const float3 value) {
    lanes->x.lane[lane] = value.x;
    lanes->y.lane[lane] = value.y;
    lanes->z.lane[lane] = value.z;
}

static float3 get_lane(const Lanes3 *lanes, const int lane) {
    return (float3)(lanes->x.lane[lane], lanes->y.lane[lane], lanes->z.lane[lane]);
}

static Wide3 load_lanes(const Lanes3 *lanes) {
    const Wide3 wide = {lanes->x.wide, lanes->y.wide, lanes->z.wide};
    return wide;
}

static void store_lanes(Lanes3 *lanes, const Wide3 wide) {
    lanes->x.wide = wide.x;
    lanes->y.wide = wide.y;
    lanes->z.wide = wide.z;
}

// The same in all lanes.
static Wide3 wide3(const float3 value) {
    const Wide3 wide = {value.x, value.y, value.z};
    return wide;
}

#define ALL_AXES -1

static Wide along_axis(const Wide3 *a, const int axis) {
    return axis == 0 ? a->x : axis == 1 ? a->y : a->z;
}

static Wide3 wide_sum(const Wide3 a, const Wide3 b) {
    const Wide3 sum = {a.x + b.x, a.y + b.y, a.z + b.z};
    return sum;
}

static Wide3 wide_difference(const Wide3 a, const Wide3 b) {
    const Wide3 difference = {a.x - b.x, a.y - b.y, a.z - b.z};
    return difference;
}

static Wide3 wide_product(const Wide3 a, const Wide3 b) {
    const Wide3 product = {a.x * b.x, a.y * b.y, a.z * b.z};
    return product;
}

static Wide3 wide_scaled(const Wide by, const Wide3 a) {
    const Wide3 scaled = {by * a.x, by * a.y, by * a.z};
    return scaled;
}

// Zero where the mask is not set.
static Wide3 masked(const WideInt mask, const Wide3 a) {
    const Wide3 masked = {mask ? a.x : (Wide)(0.0f), mask ? a.y : (Wide)(0.0f), mask ? a.z : (Wide)(0.0f)};
    return masked;
}

// by * a + b, fused.
static Wide3 wide_fused(const Wide by, const Wide3 a, const Wide3 b) {
    const Wide3 sum = {FUSED(by, a.x, b.x), FUSED(by, a.y, b.y), FUSED(by, a.z, b.z)};
    return sum;
}

// `a` turned round where the mask is set.
static Wide3 turned(const WideInt mask, const Wide3 a) {
    const Wide3 turned = {mask ? -a.x : a.x, mask ? -a.y : a.y, mask ? -a.z : a.z};
    return turned;
}

static Wide wide_dot(const Wide3 a, const Wide3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static Wide3 wide_cross(const Wide3 a, const Wide3 b) {
    const Wide3 cross = {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    return cross;
}
// #endregion wide3

// #region wide_rays
// #region packet
// A packet of rays. A lane without a ray has a t_max below 0, and hits nothing.
typedef struct WideRays {
    Wide3 origin, direction;
    Wide t_max;  // in lengths of the direction: what is hit beyond does not count
} WideRays;
// #endregion packet

static WideRays no_rays(void) {
    WideRays rays;
    rays.origin = wide3((float3)(0.0f));
    rays.direction = wide3((float3)(1.0f));
    rays.t_max = -1.0f;
    return rays;
}

typedef struct WideHits {
    WideInt shape;  // Shape
    WideInt index;
    Wide barycentric_b, barycentric_c;
} WideHits;

// #region wide_keep_closer
// What is closer than a ray's t_max is kept, and becomes it. In which lanes it was.
static WideInt wide_keep_closer(WideRays *rays, WideHits *closest, const Wide distance, const Shape shape,
                                const int index) {
    const WideInt closer = distance < rays->t_max;
    rays->t_max = closer ? distance : rays->t_max;
    closest->shape = closer ? (WideInt)(shape) : closest->shape;
    closest->index = closer ? (WideInt)(index) : closest->index;
    return closer;
}
// #endregion wide_keep_closer

static void block(WideRays *rays, const WideInt blocked) {
    rays->t_max = blocked ? (Wide)(-1.0f) : rays->t_max;
}
// #endregion wide_rays

// #region wide_surfaces
// As Surface.
typedef struct WideSurfaces {
    Wide3 position, normal, geometric_normal;
    WideInt from_behind;
    Wide ray_offset;
} WideSurfaces;
// #endregion wide_surfaces
