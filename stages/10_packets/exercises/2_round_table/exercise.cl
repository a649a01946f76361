// SPDX-License-Identifier: MIT
// #stub
// Exercise 10.2: planes with an edge, sixteen rays at a time.
// #solution
// Exercise 10.2, solved: whether the point is near enough is one more mask.
// #end

// kernels/packets/hit.cl
// #region wide_plane
#define DISC_RADIUS 1.6f

// #stub
// #solution
// Whether what is this share of its direction along a ray is within the radius of the plane's point nearest to the origin.
static WideInt on_disc(const WideRays *rays, const Wide share, const float3 normal, const float offset) {
    const Wide3 point = wide_fused(share, rays->direction, rays->origin);
    const Wide3 from_middle = wide_difference(point, wide3(offset * normal));
    return wide_dot(from_middle, from_middle) <= DISC_RADIUS * DISC_RADIUS;
}

// #end
// As intersect_ray_plane.
static Wide wide_ray_plane(const WideRays *rays, const float3 normal, const float offset) {
    const Wide t = (offset - wide_dot(wide3(normal), rays->origin))
                   / wide_dot(wide3(normal), rays->direction);
// #stub
    return t > 0.0f ? t : (Wide)(INFINITY);  // your turn
// #solution
    return ((t > 0.0f) & on_disc(rays, t, normal, offset)) ? t : (Wide)(INFINITY);
// #end
}

// #stub
// As intersect_line_plane.
static WideInt wide_line_plane(const WideRays *lines, const float3 normal, const float offset) {
    const Wide before = wide_dot(wide3(normal), lines->origin) - offset;
    const Wide after = wide_dot(wide3(normal), wide_sum(lines->origin, lines->direction)) - offset;
    return ((before < 0.0f) & (after > 0.0f)) | ((before > 0.0f) & (after < 0.0f));  // your turn
}
// #solution
// As intersect_line_plane. Where a line does not cross, its share means nothing, and the sides leave it out.
static WideInt wide_line_plane(const WideRays *lines, const float3 normal, const float offset) {
    const Wide before = wide_dot(wide3(normal), lines->origin) - offset;
    const Wide after = wide_dot(wide3(normal), wide_sum(lines->origin, lines->direction)) - offset;
    const WideInt crosses = ((before < 0.0f) & (after > 0.0f)) | ((before > 0.0f) & (after < 0.0f));
    return crosses & on_disc(lines, before / (before - after), normal, offset);
}
// #end
// #endregion wide_plane
