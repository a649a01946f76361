// SPDX-License-Identifier: MIT
// Where rays meet a sphere.
#include "packets/wide.cl"

// #region wide_ray_sphere_geometric
// As intersect_ray_sphere (sphere.cl): the distance from the centre is measured on the perpendicular.
static Wide wide_ray_sphere(const WideRays *rays, const float3 center, const float radius) {
    const Wide3 to_center = wide_difference(wide3(center), rays->origin);
    const Wide nearest = wide_dot(to_center, rays->direction);
    const Wide3 perpendicular = wide_difference(to_center, wide_scaled(nearest, rays->direction));
    const Wide half_chord = sqrt(radius * radius - wide_dot(perpendicular, perpendicular));
    const WideInt inside = wide_dot(to_center, to_center) < radius * radius;
    const Wide distance = inside ? nearest + half_chord : nearest - half_chord;
    return distance > 0.0f ? distance : (Wide)(INFINITY);
}
// #endregion wide_ray_sphere_geometric
