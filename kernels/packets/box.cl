// SPDX-License-Identifier: MIT
// Introduced by stage 10: where the rays of a packet enter a box, each for itself.
#include "box/robust.cl"
#include "packets/wide.cl"
#include "scene.cl"

static float plane_of(__global const BvhNode *node, const int row, const int child) {
    return ((__global const Single *)&node->planes[row])[child];
}

// #region slab
// A box is where three slabs meet (Kay and Kajiya, Ray Tracing Complex Scenes, 1986). This is what a
// ray's tests against all slabs of an axis have in common: the plane at p is met at the distance
// p * inverse + low, or + high; between the two lies what rounding can do (kernels/tree.cl, enter_boxes). Every
// choice between two numbers below keeps the box where one of them is not a number.

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
    const Wide padding = fabs(origin) * PADDING;
    const SlabAxis axis = {inverse, -(origin + padding) * inverse, -(origin - padding) * inverse};
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
// Where each ray enters the box of one child, if it is in it anywhere before `t_max`.
#define NOT_ENTERED MAXFLOAT

static Wide enter_box(__global const BvhNode *node, const int child, const SlabRays *rays, const Wide t_max) {
    const Wide low_x = FUSED((Wide)(plane_of(node, 0, child)), rays->x.inverse, rays->x.low);
    const Wide low_y = FUSED((Wide)(plane_of(node, 1, child)), rays->y.inverse, rays->y.low);
    const Wide low_z = FUSED((Wide)(plane_of(node, 2, child)), rays->z.inverse, rays->z.low);
    const Wide high_x = FUSED((Wide)(plane_of(node, 3, child)), rays->x.inverse, rays->x.high);
    const Wide high_y = FUSED((Wide)(plane_of(node, 4, child)), rays->y.inverse, rays->y.high);
    const Wide high_z = FUSED((Wide)(plane_of(node, 5, child)), rays->z.inverse, rays->z.high);
    const Wide enter_xy = MAX(MIN(low_x, high_x), MIN(low_y, high_y));
    const Wide leave_xy = MIN(MAX(low_x, high_x), MAX(low_y, high_y));
    const Wide enter = MAX(enter_xy, MAX(MIN(low_z, high_z), (Wide)(0.0f)));
    const Wide leave = MIN(leave_xy, MIN(MAX(low_z, high_z), t_max));
    return enter <= leave ? enter : (Wide)(NOT_ENTERED);
}
// #endregion enter_box
// #endregion slab
