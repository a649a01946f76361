// SPDX-License-Identifier: MIT
// Introduced by stage 10: what WIDTH rays hit first, and whether anything is in their way. The tests
// are those of sphere.cl and plane.cl, component by component: OpenCL C has no vectors of vectors.
#include "origin.cl"
#include "scene.cl"
#include "packets/wide.cl"
#include "packets/walk/beam.cl"

// #region wide_plane
// As intersect_ray_plane.
static Wide wide_ray_plane(const WideRays *rays, const float3 normal, const float offset) {
    const Wide t = (offset - wide_dot(wide3(normal), rays->origin)) / wide_dot(wide3(normal), rays->direction);
    return t > 0.0f ? t : (Wide)(INFINITY);
}

// As intersect_line_plane.
static WideInt wide_line_plane(const WideRays *lines, const float3 normal, const float offset) {
    const Wide before = wide_dot(wide3(normal), lines->origin) - offset;
    const Wide after = wide_dot(wide3(normal), wide_sum(lines->origin, lines->direction)) - offset;
    return ((before < 0.0f) & (after > 0.0f)) | ((before > 0.0f) & (after < 0.0f));
}
// #endregion wide_plane

// #region closest_hits
// As closest_hit, of all packets. A ray's t_max becomes the distance of what it hits.
static void closest_hits(const Scene *scene, WideRays *rays, WideHits *closest) {
    for (int packet = 0; packet < PACKETS; ++packet) {
        const WideHits none = {SHAPE_NONE, 0, 0.0f, 0.0f};
        closest[packet] = none;
        for (int i = 0; i < scene->plane_count; ++i) {
            const Plane plane = scene->planes[i];
            wide_keep_closer(&rays[packet], &closest[packet],
                             wide_ray_plane(&rays[packet], XYZ(plane.normal), plane.offset), SHAPE_PLANE, i);
        }
    }
    if (HAS_TREE) {
        walk(scene, rays, false, closest);
    }
}
// #endregion closest_hits

// #region block_hits
// As any_hit_ray, or any_hit_line where the rays `are_lines`, of all packets: those with something in
// their way lose their t_max.
static void block_hits(const Scene *scene, WideRays *rays, const bool are_lines) {
    for (int packet = 0; packet < PACKETS; ++packet) {
        for (int i = 0; i < scene->plane_count; ++i) {
            const float3 normal = XYZ(scene->planes[i].normal);
            const float offset = scene->planes[i].offset;
            block(&rays[packet], are_lines ? wide_line_plane(&rays[packet], normal, offset)
                                           : wide_ray_plane(&rays[packet], normal, offset) < INFINITY);
        }
    }
    if (HAS_TREE) {
        walk(scene, rays, are_lines, 0);
    }
}
// #endregion block_hits
