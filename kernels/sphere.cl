// SPDX-License-Identifier: MIT
// Introduced by stage 01; extended by 02 (lines): where rays and lines meet a sphere.
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

// #region line_sphere
// Only whether, not where. With one end inside, the line crosses the surface; with none, it
// does when the point nearest the centre lies inside, between the ends.
static bool intersect_line_sphere(const Line line, const float3 center, const float radius) {
    const float3 along = line.destination - line.origin;
    const float3 to_center = center - line.origin;
    const float3 from_destination = center - line.destination;
    const float radius_squared = radius * radius;
    const bool origin_inside = dot(to_center, to_center) < radius_squared;
    const bool destination_inside = dot(from_destination, from_destination) < radius_squared;
    if (origin_inside || destination_inside) {
        return origin_inside != destination_inside;
    }
    const float nearest = dot(to_center, along) / dot(along, along);  // 0 to 1 on the line
    const float3 perpendicular = to_center - nearest * along;
    return nearest > 0.0f && nearest < 1.0f && dot(perpendicular, perpendicular) < radius_squared;
}
// #endregion line_sphere
