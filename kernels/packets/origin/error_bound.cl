// SPDX-License-Identifier: MIT
// Introduced by stage 10: where rays start that leave surfaces, as origin/error_bound.cl has it. To the side of
// `normals`.
#include "packets/wide.cl"

static Wide3 wide_offset_along(const WideSurfaces *surfaces, const Wide3 normals) {
    return wide_sum(surfaces->position, wide_scaled(surfaces->ray_offset, normals));
}

// As ray_offset, where the rays have met the surfaces at their t_max.
static Wide wide_ray_offset(const WideRays *rays, const Wide bound) {
    return bound;
}
