// SPDX-License-Identifier: MIT
// Introduced by stage 09: numbers for WIDTH rays at a time, a lane for each. A GPU puts work-items
// side by side by itself: there WIDTH is 1, and all of this is scalar. A CPU's vector unit is given
// 4, 8 or 16 numbers at once by the one work-item that traces so many pixels.
#include "scene_types.h"

// #region wide
#define JOIN_NAMES(a, b) a##b
#define JOIN(a, b) JOIN_NAMES(a, b)

// A mask is what comparing two Wide gives: in a lane it is 0, or else 1 (WIDTH 1) or -1 (all bits).
#if WIDTH == 1
typedef float Wide;
typedef int WideInt;
#define LOAD_WIDE(lanes) (*(lanes))
#define STORE_WIDE(value, lanes) (*(lanes) = (value))
#else
typedef JOIN(float, WIDTH) Wide;
typedef JOIN(int, WIDTH) WideInt;
#define LOAD_WIDE(lanes) JOIN(vload, WIDTH)(0, lanes)
#define STORE_WIDE(value, lanes) JOIN(vstore, WIDTH)(value, 0, lanes)
#endif

// The pixels of one work-item, close together so that their rays are too: how many in a row, and where
// each lane's is from the upper left one.
#define TILE_WIDTH TILE_WIDTH_OF(WIDTH)
#define TILE_HEIGHT (WIDTH / TILE_WIDTH)
#if WIDTH == 1
#define LANE_X 0.0f
#define LANE_Y 0.0f
#elif WIDTH == 4
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
// The second where the first is not a number. Compare and select are an instruction each; fmin and
// fmax are more.
static Wide smaller(const Wide a, const Wide b) {
    return a < b ? a : b;
}

static Wide larger(const Wide a, const Wide b) {
    return a > b ? a : b;
}

// Whether a mask is set in any lane. PoCL's any() is several times slower.
static bool any_lane(const WideInt mask) {
#if WIDTH == 1
    return mask;
#else
#if WIDTH == 16
    const int8 eight = mask.lo | mask.hi;
    const int4 four = eight.lo | eight.hi;
#elif WIDTH == 8
    const int4 four = mask.lo | mask.hi;
#else
    const int4 four = mask;
#endif
    const int2 two = four.lo | four.hi;
    return two.x | two.y;
#endif
}

static int sum_of_lanes(const WideInt numbers) {
    int lanes[WIDTH];
    STORE_WIDE(numbers, lanes);
    int sum = 0;
    for (int lane = 0; lane < WIDTH; ++lane) {
        sum += lanes[lane];
    }
    return sum;
}

// Of numbers only: no NaN.
static float smallest_lane(const Wide lanes) {
#if WIDTH == 1
    return lanes;
#else
#if WIDTH == 16
    const float8 eight = lanes.lo < lanes.hi ? lanes.lo : lanes.hi;
    const float4 four = eight.lo < eight.hi ? eight.lo : eight.hi;
#elif WIDTH == 8
    const float4 four = lanes.lo < lanes.hi ? lanes.lo : lanes.hi;
#else
    const float4 four = lanes;
#endif
    const float2 two = four.lo < four.hi ? four.lo : four.hi;
    return two.x < two.y ? two.x : two.y;
#endif
}

static float largest_lane(const Wide lanes) {
    return -smallest_lane(-lanes);
}
// #endregion lanes

// #region wide3
// A vector for each ray: to calculate with, and in memory, where each lane can be reached.
typedef struct Wide3 {
    Wide x, y, z;
} Wide3;

typedef struct Lanes3 {
    float x[WIDTH], y[WIDTH], z[WIDTH];
} Lanes3;

static void put_lane(Lanes3 *lanes, const int lane, const float3 value) {
    lanes->x[lane] = value.x;
    lanes->y[lane] = value.y;
    lanes->z[lane] = value.z;
}

static float3 get_lane(const Lanes3 *lanes, const int lane) {
    return (float3)(lanes->x[lane], lanes->y[lane], lanes->z[lane]);
}

static Wide3 load_lanes(const Lanes3 *lanes) {
    const Wide3 wide = {LOAD_WIDE(lanes->x), LOAD_WIDE(lanes->y), LOAD_WIDE(lanes->z)};
    return wide;
}

static void store_lanes(Lanes3 *lanes, const Wide3 wide) {
    STORE_WIDE(wide.x, lanes->x);
    STORE_WIDE(wide.y, lanes->y);
    STORE_WIDE(wide.z, lanes->z);
}

// The same in all lanes.
static Wide3 wide3(const float3 value) {
    const Wide3 wide = {value.x, value.y, value.z};
    return wide;
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

static Wide wide_dot(const Wide3 a, const Wide3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static Wide3 wide_cross(const Wide3 a, const Wide3 b) {
    const Wide3 cross = {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    return cross;
}

static Wide3 wide_normalized(const Wide3 a) {
    return wide_scaled(1.0f / sqrt(wide_dot(a, a)), a);
}
// #endregion wide3

// #region wide_rays
// A lane without a ray has a limit below 0, and hits nothing.
typedef struct WideRays {
    Wide3 origin, direction;
    Wide limit;  // in lengths of the direction: what is hit beyond does not count
} WideRays;

typedef struct WideHits {
    Wide distance;  // the ray's limit where nothing was hit
    WideInt shape;  // Shape
    WideInt index;
    Wide barycentric_b, barycentric_c;
} WideHits;
// #endregion wide_rays
