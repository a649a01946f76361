// SPDX-License-Identifier: MIT
// Introduced by stage 09: where rays start that leave WIDTH surfaces, as origin.cl has it.
#include "origin.cl"
#include "wide.cl"

// #region wide_surfaces
// As Surface.
typedef struct WideSurfaces {
    Wide3 position, normal, geometric_normal;
    WideInt from_behind;
    Wide reach;
#if HAS_ORIGIN_ERROR
    Wide3 error;
#endif
} WideSurfaces;
// #endregion wide_surfaces

// #region wide_leave
// To the side of `normals`.
#define wide_leave JOIN(wide_leave_, METHOD_ORIGIN)

static Wide3 wide_leave_fixed(const WideSurfaces *surfaces, const Wide3 normals) {
    return wide_sum(surfaces->position, wide_scaled(FIXED_OFFSET, normals));
}

static Wide3 wide_leave_scaled(const WideSurfaces *surfaces, const Wide3 normals) {
    return wide_sum(surfaces->position, wide_scaled(SCALED_OFFSET * surfaces->reach, normals));
}

static Wide wide_leave_integer_axis(const Wide position, const Wide normal) {
    const WideInt steps = TO_WIDE_INT(INTEGER_STEPS * normal);
    const Wide moved = AS_WIDE(AS_WIDE_INT(position) + (position < 0.0f ? -steps : steps));
    return fabs(position) < NEAR_ZERO ? position + NEAR_ZERO_OFFSET * normal : moved;
}

static Wide3 wide_leave_integer(const WideSurfaces *surfaces, const Wide3 normals) {
    const Wide3 origin = {wide_leave_integer_axis(surfaces->position.x, normals.x),
                          wide_leave_integer_axis(surfaces->position.y, normals.y),
                          wide_leave_integer_axis(surfaces->position.z, normals.z)};
    return origin;
}

#if HAS_ORIGIN_ERROR
static Wide wide_leave_error_bound_axis(const Wide position, const Wide offset) {
    const Wide away = offset > 0.0f ? (Wide)(INFINITY) : (Wide)(-INFINITY);
    const Wide moved = position + offset;
    return offset == 0.0f ? moved : nextafter(moved, away);
}

static Wide3 wide_leave_error_bound(const WideSurfaces *surfaces, const Wide3 normals) {
    const Wide distance = fabs(normals.x) * surfaces->error.x + fabs(normals.y) * surfaces->error.y
                          + fabs(normals.z) * surfaces->error.z;
    const Wide3 offset = wide_scaled(distance, normals);
    const Wide3 origin = {wide_leave_error_bound_axis(surfaces->position.x, offset.x),
                          wide_leave_error_bound_axis(surfaces->position.y, offset.y),
                          wide_leave_error_bound_axis(surfaces->position.z, offset.z)};
    return origin;
}
#endif
// #endregion wide_leave

// #region wide_origin_off
// As origin_off.
static Wide3 wide_origin_off(const WideSurfaces *surfaces, const Wide3 direction) {
    const WideInt beneath = wide_dot(surfaces->geometric_normal, direction) < 0.0f;
    return wide_leave(surfaces, turned(beneath, surfaces->geometric_normal));
}

// As reach_of.
static Wide wide_reach_of(const WideRays *rays) {
    const Wide x = fabs(rays->origin.x);
    const Wide y = fabs(rays->origin.y);
    const Wide z = fabs(rays->origin.z);
    return larger(x, larger(y, z)) + rays->limit;
}
// #endregion wide_origin_off
