// SPDX-License-Identifier: MIT
// Introduced by stage 09: where rays start that leave WIDTH surfaces, as origin.cl has it.
#include "origin.cl"
#include "wide.cl"

// #region wide_surfaces
// As Surface.
typedef struct WideSurfaces {
    Wide3 position, normal, geometric_normal;
    WideInt from_behind;
    Wide offset;
} WideSurfaces;
// #endregion wide_surfaces

// #region wide_leave
// To the side of `normals`.
#define wide_leave JOIN(wide_leave_, METHOD_ORIGIN)

static Wide3 wide_leave_error_bound(const WideSurfaces *surfaces, const Wide3 normals) {
    return wide_sum(surfaces->position, wide_scaled(surfaces->offset, normals));
}

static Wide3 wide_leave_scaled(const WideSurfaces *surfaces, const Wide3 normals) {
    return wide_sum(surfaces->position, wide_scaled(surfaces->offset, normals));
}

static Wide wide_scaled_offset(const WideRays *rays) {
    const Wide x = fabs(rays->origin.x);
    const Wide y = fabs(rays->origin.y);
    const Wide z = fabs(rays->origin.z);
    return SCALED_OFFSET * (larger(x, larger(y, z)) + rays->limit);
}

static Wide3 wide_leave_fixed(const WideSurfaces *surfaces, const Wide3 normals) {
    return wide_sum(surfaces->position, wide_scaled(FIXED_OFFSET, normals));
}

static Wide wide_leave_integer_axis(const Wide position, const Wide normal) {
    const WideInt steps = WIDE(TO_LANE_INT)(INTEGER_STEPS * normal);
    const Wide moved =
        WIDE(AS_REAL)(WIDE(AS_LANE_INT)(position) + (position < 0.0f ? -steps : steps));
    return fabs(position) < NEAR_ZERO ? position + NEAR_ZERO_OFFSET * normal : moved;
}

static Wide3 wide_leave_integer(const WideSurfaces *surfaces, const Wide3 normals) {
    const Wide3 origin = {wide_leave_integer_axis(surfaces->position.x, normals.x),
                          wide_leave_integer_axis(surfaces->position.y, normals.y),
                          wide_leave_integer_axis(surfaces->position.z, normals.z)};
    return origin;
}
// #endregion wide_leave

// #region wide_origin_off
// As origin_off.
static Wide3 wide_origin_off(const WideSurfaces *surfaces, const Wide3 direction) {
    const WideInt beneath = wide_dot(surfaces->geometric_normal, direction) < 0.0f;
    return wide_leave(surfaces, turned(beneath, surfaces->geometric_normal));
}
// #endregion wide_origin_off
