// SPDX-License-Identifier: MIT
// Introduced by stage 10: where rays start that leave WIDTH surfaces, as origin.cl has it.
#include "origin.cl"
#include "packets/wide.cl"

#include "packets/origin/error_bound.cl"

// #region wide_offset_ray_origin
// As offset_ray_origin.
static Wide3 wide_offset_ray_origin(const WideSurfaces *surfaces, const Wide3 direction) {
    const WideInt beneath = wide_dot(surfaces->geometric_normal, direction) < 0.0f;
    return wide_offset_along(surfaces, turned(beneath, surfaces->geometric_normal));
}
// #endregion wide_offset_ray_origin
