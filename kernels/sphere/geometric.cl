// SPDX-License-Identifier: MIT
// Introduced by stage 01: where rays meet a sphere.
#include "ray.cl"

// #region ray_sphere
// The geometric way: go along the ray to the point nearest the centre, and from there back
// by half the chord. That point's distance from the centre is measured on the perpendicular
// itself, not as a difference of squares, which far away would cancel to noise (Haines et
// al., Ray Tracing Gems, 2019, chapter 7).
static float intersect_ray_sphere(const Ray ray, const float3 center, const float radius) {
    const float3 to_center = center - ray.origin;
    const float nearest = dot(to_center, ray.direction);
    const float3 perpendicular = to_center - nearest * ray.direction;
    const float half_chord_squared = radius * radius - dot(perpendicular, perpendicular);
    if (half_chord_squared < 0.0f) {
        return INFINITY;
    }
    const float half_chord = sqrt(half_chord_squared);
    const bool inside = dot(to_center, to_center) < radius * radius;
    const float distance = inside ? nearest + half_chord : nearest - half_chord;
    return distance > 0.0f ? distance : INFINITY;
}
// #endregion ray_sphere
