// SPDX-License-Identifier: MIT
// Introduced by stage 09: where WIDTH rays and lines meet a sphere.
#include "wide.cl"

// #region wide_ray_sphere
// To where each ray enters the sphere or, from inside, leaves it; INFINITY for a miss. All ways go to the
// point nearest the centre, and from there back by half the chord; they differ in how they find both.
// Every comparison is false where half the chord is not a number.
#ifndef METHOD_SPHERE
#define METHOD_SPHERE haines
#endif
#define wide_ray_sphere JOIN(wide_ray_sphere_, METHOD_SPHERE)
// #endregion wide_ray_sphere

// #region wide_ray_sphere_textbook
// t * t + b * t + c = 0, by the formula of school. Far away b * b and 4 * c are nearly one and the same,
// and what is left is noise.
static Wide wide_ray_sphere_textbook(const WideRays *rays, const float3 center,
                                     const float radius) {
    const Wide3 from_center = wide_difference(rays->origin, wide3(center));
    const Wide b = 2.0f * wide_dot(from_center, rays->direction);
    const Wide c = wide_dot(from_center, from_center) - radius * radius;
    const Wide root = sqrt(b * b - 4.0f * c);
    const Wide distance = 0.5f * (c < 0.0f ? -b + root : -b - root);
    return distance > 0.0f ? distance : (Wide)(INFINITY);
}
// #endregion wide_ray_sphere_textbook

// #region wide_ray_sphere_geometric
// As intersect_ray_sphere (sphere.cl): the distance from the centre is measured on the perpendicular.
static Wide wide_ray_sphere_geometric(const WideRays *rays, const float3 center,
                                      const float radius) {
    const Wide3 to_center = wide_difference(wide3(center), rays->origin);
    const Wide nearest = wide_dot(to_center, rays->direction);
    const Wide3 perpendicular = wide_difference(to_center, wide_scaled(nearest, rays->direction));
    const Wide half_chord = sqrt(radius * radius - wide_dot(perpendicular, perpendicular));
    const WideInt inside = wide_dot(to_center, to_center) < radius * radius;
    const Wide distance = inside ? nearest + half_chord : nearest - half_chord;
    return distance > 0.0f ? distance : (Wide)(INFINITY);
}
// #endregion wide_ray_sphere_geometric

// #region wide_ray_sphere_haines
// Of the two roots the one without a difference is worked out, and the other from their product c (Haines
// et al., Precision Improvements for Ray/Sphere Intersection, Ray Tracing Gems, 2019, chapter 7). And the
// perpendicular is rounded once, not on its way, where the device can do that; what `nearest` is off by is
// taken from it afterwards.
static Wide wide_ray_sphere_haines(const WideRays *rays, const float3 center, const float radius) {
    const Wide3 to_center = wide_difference(wide3(center), rays->origin);
    const Wide nearest = wide_dot(to_center, rays->direction);
    const Wide3 nearly = wide_fused(-nearest, rays->direction, to_center);
    const Wide3 perpendicular =
        wide_fused(-wide_dot(nearly, rays->direction), rays->direction, nearly);
    const Wide half_chord = sqrt(radius * radius - wide_dot(perpendicular, perpendicular));
    const Wide c = wide_dot(to_center, to_center) - radius * radius;
    const Wide sum = nearest + (nearest < 0.0f ? -half_chord : half_chord);
    const WideInt is_sum = (c < 0.0f) ^ (nearest < 0.0f);
    const Wide distance = is_sum ? sum : c / sum;
    return distance > 0.0f ? distance : (Wide)(INFINITY);
}
// #endregion wide_ray_sphere_haines

// #region wide_line_sphere
// As intersect_line_sphere; a line ends after one length of its direction.
static WideInt wide_line_sphere(const WideRays *lines, const float3 center, const float radius) {
    const float radius_squared = radius * radius;
    const Wide3 along = lines->direction;
    const Wide3 to_center = wide_difference(wide3(center), lines->origin);
    const Wide3 from_destination = wide_difference(to_center, along);
    const WideInt origin_inside = wide_dot(to_center, to_center) < radius_squared;
    const WideInt destination_inside =
        wide_dot(from_destination, from_destination) < radius_squared;
    const Wide nearest = wide_dot(to_center, along) / wide_dot(along, along);
    const Wide3 perpendicular = wide_difference(to_center, wide_scaled(nearest, along));
    const WideInt passes = (nearest > 0.0f) & (nearest < 1.0f)
                           & (wide_dot(perpendicular, perpendicular) < radius_squared);
    return (origin_inside | destination_inside) ? origin_inside ^ destination_inside : passes;
}
// #endregion wide_line_sphere
