// SPDX-License-Identifier: MIT
// Exercise 10.3, solved: each wall has a mask of its own.

// kernels/packets/sphere/haines.cl
// #region wide_ray_sphere_haines
// Whether what is this share of its direction along a ray lies ahead, and in the lower half of the sphere.
static WideInt in_bowl(const WideRays *rays, const Wide share, const float3 center) {
    const Wide height = rays->origin.y + share * rays->direction.y;
    return (share > 0.0f) & (height <= center.y);
}

// To the nearest wall ahead of each ray that is there; INFINITY for none. Every comparison is false where half the chord
// is not a number.
static Wide wide_ray_sphere(const WideRays *rays, const float3 center, const float radius) {
    const Wide3 to_center = wide_difference(wide3(center), rays->origin);
    const Wide nearest = wide_dot(to_center, rays->direction);
    const Wide3 perpendicular = wide_difference(to_center, wide_scaled(nearest, rays->direction));
    const Wide half_chord = sqrt(radius * radius - wide_dot(perpendicular, perpendicular));
    const Wide near = nearest - half_chord;
    const Wide far = nearest + half_chord;
    return in_bowl(rays, near, center) ? near : in_bowl(rays, far, center) ? far : (Wide)(INFINITY);
}
// #endregion wide_ray_sphere_haines

// kernels/packets/sphere.cl
// #region wide_line_sphere
// Whether a wall that is there lies between the ends of each line; it ends after one length of its direction.
static WideInt wide_line_sphere(const WideRays *lines, const float3 center, const float radius) {
    const Wide squared = wide_dot(lines->direction, lines->direction);
    const Wide3 to_center = wide_difference(wide3(center), lines->origin);
    const Wide nearest = wide_dot(to_center, lines->direction) / squared;
    const Wide3 perpendicular = wide_difference(to_center, wide_scaled(nearest, lines->direction));
    const Wide half_chord = sqrt((radius * radius - wide_dot(perpendicular, perpendicular)) / squared);
    const Wide near = nearest - half_chord;
    const Wide far = nearest + half_chord;
    return (in_bowl(lines, near, center) & (near < 1.0f)) | (in_bowl(lines, far, center) & (far < 1.0f));
}
// #endregion wide_line_sphere
