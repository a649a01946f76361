// SPDX-License-Identifier: MIT
// As origin/integer.cl.
#include "origin/integer.cl"
#include "packets/wide.cl"

static Wide wide_offset_axis(const Wide position, const Wide normal) {
    const WideInt steps = JOIN(TO_LANE_INT, WIDTH)(INTEGER_STEPS * normal);
    const Wide moved =
        JOIN(AS_REAL, WIDTH)(JOIN(AS_LANE_INT, WIDTH)(position) + (position < 0.0f ? -steps : steps));
    return fabs(position) < NEAR_ZERO ? position + NEAR_ZERO_OFFSET * normal : moved;
}

static Wide3 wide_offset_along(const WideSurfaces *surfaces, const Wide3 normals) {
    const Wide3 origin = {wide_offset_axis(surfaces->position.x, normals.x),
                          wide_offset_axis(surfaces->position.y, normals.y),
                          wide_offset_axis(surfaces->position.z, normals.z)};
    return origin;
}

static Wide wide_ray_offset(const WideRays *rays, const Wide bound) {
    return bound;
}
