// SPDX-License-Identifier: MIT
// Introduced by stage 02: where lines meet a sphere.
#include "ray.cl"
#include "sphere/geometric.cl"

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
