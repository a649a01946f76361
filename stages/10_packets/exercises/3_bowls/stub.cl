// SPDX-License-Identifier: MIT
// Exercise 10.3: spheres without their upper halves, many rays at a time.

// kernels/packets/sphere/haines.cl
// #region wide_ray_sphere_haines
// To the nearest wall ahead of each ray that is there; INFINITY for none. Every comparison is false where half the chord
// is not a number.
static Wide wide_ray_sphere(const WideRays *rays, const float3 center, const float radius) {
    const Wide3 to_center = wide_difference(wide3(center), rays->origin);
    const Wide nearest = wide_dot(to_center, rays->direction);
    const Wide3 perpendicular = wide_difference(to_center, wide_scaled(nearest, rays->direction));
    const Wide half_chord = sqrt(radius * radius - wide_dot(perpendicular, perpendicular));
    const Wide near = nearest - half_chord;
    const Wide far = nearest + half_chord;
    // your turn
    return near > 0.0f ? near : far > 0.0f ? far : (Wide)(INFINITY);
}
// #endregion wide_ray_sphere_haines

// kernels/packets/sphere.cl
// #region wide_line_sphere
// Whether a wall that is there lies between the ends of each line; it ends after one length of its direction.
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
    // your turn
    return (origin_inside | destination_inside) ? origin_inside ^ destination_inside : passes;
}
// #endregion wide_line_sphere
