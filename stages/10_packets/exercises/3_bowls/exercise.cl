// SPDX-License-Identifier: MIT
// #stub
// Exercise 10.3: spheres without their upper halves, many rays at a time.
// #solution
// Exercise 10.3, solved: each wall has a mask of its own.
// #end

// kernels/packets/sphere/haines.cl
// #region wide_ray_sphere_haines
// #stub
// #solution
// Whether what is this share of its direction along a ray lies ahead, and in the lower half of the sphere.
static WideInt in_bowl(const WideRays *rays, const Wide share, const float3 center) {
    const Wide height = rays->origin.y + share * rays->direction.y;
    return (share > 0.0f) & (height <= center.y);
}

// #end
// To the nearest wall ahead of each ray that is there; INFINITY for none. Every comparison is false where half the chord
// is not a number.
static Wide wide_ray_sphere(const WideRays *rays, const float3 center, const float radius) {
    const Wide3 to_center = wide_difference(wide3(center), rays->origin);
    const Wide nearest = wide_dot(to_center, rays->direction);
    const Wide3 perpendicular = wide_difference(to_center, wide_scaled(nearest, rays->direction));
    const Wide half_chord = sqrt(radius * radius - wide_dot(perpendicular, perpendicular));
    const Wide near = nearest - half_chord;
    const Wide far = nearest + half_chord;
// #stub
    // your turn
    return near > 0.0f ? near : far > 0.0f ? far : (Wide)(INFINITY);
// #solution
    return in_bowl(rays, near, center) ? near : in_bowl(rays, far, center) ? far : (Wide)(INFINITY);
// #end
}
// #endregion wide_ray_sphere_haines

// kernels/packets/sphere.cl
// #region wide_line_sphere
// Whether a wall that is there lies between the ends of each line; it ends after one length of its direction.
static WideInt wide_line_sphere(const WideRays *lines, const float3 center, const float radius) {
// #stub
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
// #solution
    const Wide squared = wide_dot(lines->direction, lines->direction);
    const Wide3 to_center = wide_difference(wide3(center), lines->origin);
    const Wide nearest = wide_dot(to_center, lines->direction) / squared;
    const Wide3 perpendicular = wide_difference(to_center, wide_scaled(nearest, lines->direction));
    const Wide half_chord = sqrt((radius * radius - wide_dot(perpendicular, perpendicular)) / squared);
    const Wide near = nearest - half_chord;
    const Wide far = nearest + half_chord;
    return (in_bowl(lines, near, center) & (near < 1.0f)) | (in_bowl(lines, far, center) & (far < 1.0f));
// #end
}
// #endregion wide_line_sphere
