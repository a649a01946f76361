// SPDX-License-Identifier: MIT
// Introduced by stage 01; extended by 05 (triangles): what a ray hits first.
#include "origin.cl"
#include "plane.cl"
#include "scene.cl"
#include "sphere.cl"
#include "triangle.cl"

// #region closest_hit
// #region keep_closer
static void keep_closer(Hit *closest, const float distance, const Shape shape, const int index) {
    if (distance < closest->distance) {
        closest->distance = distance;
        closest->shape = shape;
        closest->index = index;
    }
}
// #endregion keep_closer

static Hit closest_hit(const Scene *scene, const Ray ray) {
    Hit closest;
    closest.distance = INFINITY;
    closest.shape = SHAPE_NONE;
// #region each_sphere
    for (int i = 0; i < scene->sphere_count; ++i) {
        const Sphere sphere = scene->spheres[i];
        keep_closer(&closest, intersect_ray_sphere(ray, XYZ(sphere.center), sphere.radius),
                    SHAPE_SPHERE, i);
    }
// #endregion each_sphere
    for (int i = 0; i < scene->plane_count; ++i) {
        const Plane plane = scene->planes[i];
        keep_closer(&closest, intersect_ray_plane(ray, XYZ(plane.normal), plane.offset), SHAPE_PLANE,
                    i);
    }
    // #region closest_triangle
    for (int i = 0; i < scene->triangle_count; ++i) {
        float2 barycentric;
        const float distance =
            intersect_ray_triangle(ray, triangle_edges(scene, i), &barycentric);
        if (distance < closest.distance) {
            closest.barycentric = barycentric;
        }
        keep_closer(&closest, distance, SHAPE_TRIANGLE, i);
    }
    // #endregion closest_triangle
    return closest;
}
// #endregion closest_hit
