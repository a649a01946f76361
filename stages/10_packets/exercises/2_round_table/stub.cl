// SPDX-License-Identifier: MIT
// Exercise 10.2: planes with an edge, sixteen rays at a time.

// kernels/packets/hit.cl
// #region wide_plane
#define DISC_RADIUS 1.6f

// As intersect_ray_plane.
static Wide wide_ray_plane(const WideRays *rays, const float3 normal, const float offset) {
    const Wide t = (offset - wide_dot(wide3(normal), rays->origin))
                   / wide_dot(wide3(normal), rays->direction);
    return t > 0.0f ? t : (Wide)(INFINITY);  // your turn
}

// As intersect_line_plane.
static WideInt wide_line_plane(const WideRays *lines, const float3 normal, const float offset) {
    const Wide before = wide_dot(wide3(normal), lines->origin) - offset;
    const Wide after = wide_dot(wide3(normal), wide_sum(lines->origin, lines->direction)) - offset;
    return ((before < 0.0f) & (after > 0.0f)) | ((before > 0.0f) & (after < 0.0f));  // your turn
}
// #endregion wide_plane
