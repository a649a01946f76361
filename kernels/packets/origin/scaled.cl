// SPDX-License-Identifier: MIT
// As origin/scaled.cl.
#include "origin/scaled.cl"
#include "packets/wide.cl"

static Wide3 wide_offset_along(const WideSurfaces *surfaces, const Wide3 normals) {
    return wide_sum(surfaces->position, wide_scaled(surfaces->ray_offset, normals));
}

static Wide wide_ray_offset(const WideRays *rays, const Wide bound) {
    const Wide x = fabs(rays->origin.x);
    const Wide y = fabs(rays->origin.y);
    const Wide z = fabs(rays->origin.z);
    return SCALED_OFFSET * (MAX(x, MAX(y, z)) + rays->t_max);
}
