// SPDX-License-Identifier: MIT
// Introduced by stage 09: what WIDTH rays hit first, and whether anything is in their way. The tests
// are those of sphere.cl and plane.cl, component by component: OpenCL C has no vectors of vectors.
#include "scene.cl"
#include "wide.cl"
#if BVH_WIDTH > 0
#include "bvh.cl"
#endif

// #region wide_sphere
// As intersect_ray_sphere.
static Wide wide_ray_sphere(const WideRays *rays, const float3 center, const float radius) {
    const Wide3 to_center = wide_difference(wide3(center), rays->origin);
    const Wide nearest = wide_dot(to_center, rays->direction);
    const Wide3 perpendicular = wide_difference(to_center, wide_scaled(nearest, rays->direction));
    const Wide half_chord_squared = radius * radius - wide_dot(perpendicular, perpendicular);
    const Wide half_chord = sqrt(half_chord_squared);
    const WideInt inside = wide_dot(to_center, to_center) < radius * radius;
    const Wide distance = inside ? nearest + half_chord : nearest - half_chord;
    return distance > 0.0f ? distance : (Wide)(INFINITY);  // false where the root is not a number
}

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
// #endregion wide_sphere

// #region wide_plane
// As intersect_ray_plane.
static Wide wide_ray_plane(const WideRays *rays, const float3 normal, const float offset) {
    const Wide t = (offset - wide_dot(wide3(normal), rays->origin))
                   / wide_dot(wide3(normal), rays->direction);
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
// As closest_hit, of all packets. A ray's limit becomes the distance of what it hits.
static void closest_hits(const Scene *scene, WideRays *rays, WideHits *closest) {
    for (int packet = 0; packet < PACKETS; ++packet) {
        const WideHits none = {SHAPE_NONE, 0, 0.0f, 0.0f};
        closest[packet] = none;
#if SPHERE_COUNT > 0
        for (int i = 0; i < SPHERE_COUNT; ++i) {
            const Sphere sphere = scene->spheres[i];
            keep_closer(&rays[packet], &closest[packet],
                        wide_ray_sphere(&rays[packet], sphere.center.xyz, sphere.radius),
                        SHAPE_SPHERE, i);
        }
#endif
#if PLANE_COUNT > 0
        for (int i = 0; i < PLANE_COUNT; ++i) {
            const Plane plane = scene->planes[i];
            keep_closer(&rays[packet], &closest[packet],
                        wide_ray_plane(&rays[packet], plane.normal.xyz, plane.offset), SHAPE_PLANE,
                        i);
        }
#endif
    }
#if BVH_WIDTH > 0
    closest_triangle(scene, rays, closest);
#endif
}
// #endregion closest_hits

// #region block_hits
// As any_hit_ray, or any_hit_line where the rays `are_lines`, of all packets: those with something in
// their way lose their limit.
static void block_hits(const Scene *scene, WideRays *rays, const bool are_lines) {
    for (int packet = 0; packet < PACKETS; ++packet) {
#if SPHERE_COUNT > 0
        for (int i = 0; i < SPHERE_COUNT; ++i) {
            const float3 center = scene->spheres[i].center.xyz;
            const float radius = scene->spheres[i].radius;
            block(&rays[packet],
                  are_lines ? wide_line_sphere(&rays[packet], center, radius)
                            : wide_ray_sphere(&rays[packet], center, radius) < INFINITY);
        }
#endif
#if PLANE_COUNT > 0
        for (int i = 0; i < PLANE_COUNT; ++i) {
            const float3 normal = scene->planes[i].normal.xyz;
            const float offset = scene->planes[i].offset;
            block(&rays[packet], are_lines
                                     ? wide_line_plane(&rays[packet], normal, offset)
                                     : wide_ray_plane(&rays[packet], normal, offset) < INFINITY);
        }
#endif
    }
#if BVH_WIDTH > 0
    block_triangles(scene, rays);
#endif
}
// #endregion block_hits
