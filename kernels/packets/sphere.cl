// SPDX-License-Identifier: MIT
// Introduced by stage 10: where WIDTH rays and lines meet a sphere.
#include "packets/wide.cl"

// #region wide_ray_sphere
// To where each ray enters the sphere or, from inside, leaves it; INFINITY for a miss. All ways go to the
// point nearest the centre, and from there back by half the chord; they differ in how they find both.
// Every comparison is false where half the chord is not a number.
#include "packets/sphere/haines.cl"
// #endregion wide_ray_sphere

// #region wide_line_sphere
// As intersect_line_sphere; a line ends after one length of its direction.
static WideInt wide_line_sphere(const WideRays *lines, const float3 center, const float radius) {
    const float radius_squared = radius * radius;
    const Wide3 along = lines->direction;
    const Wide3 to_center = wide_difference(wide3(center), lines->origin);
    const Wide3 from_destination = wide_difference(to_center, along);
    const WideInt origin_inside = wide_dot(to_center, to_center) < radius_squared;
    const WideInt destination_inside = wide_dot(from_destination, from_destination) < radius_squared;
    const Wide nearest = wide_dot(to_center, along) / wide_dot(along, along);
    const Wide3 perpendicular = wide_difference(to_center, wide_scaled(nearest, along));
    const WideInt passes =
        (nearest > 0.0f) & (nearest < 1.0f) & (wide_dot(perpendicular, perpendicular) < radius_squared);
    return (origin_inside | destination_inside) ? origin_inside ^ destination_inside : passes;
}
// #endregion wide_line_sphere
