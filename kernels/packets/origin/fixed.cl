// SPDX-License-Identifier: MIT
// As origin/fixed.cl.
#include "origin/fixed.cl"
#include "packets/wide.cl"

static Wide3 wide_offset_along(const WideSurfaces *surfaces, const Wide3 normals) {
    return wide_sum(surfaces->position, wide_scaled(FIXED_OFFSET, normals));
}

static Wide wide_ray_offset(const WideRays *rays, const Wide bound) {
    return FIXED_OFFSET;
}
