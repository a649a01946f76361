// SPDX-License-Identifier: MIT
// Introduced by stage 02; extended by 05 (triangles): whether anything is in the way. The first
// thing found will do, so this is cheaper than the closest hit.
#include "origin.cl"
#include "plane.cl"
#include "scene.cl"
#include "sphere.cl"
#include "triangle.cl"

// #region any_hit
static bool any_hit_ray(const Scene *scene, const Ray ray) {
    for (int i = 0; i < scene->sphere_count; ++i) {
        const Sphere sphere = scene->spheres[i];
        if (intersect_ray_sphere(ray, XYZ(sphere.center), sphere.radius) < INFINITY) {
            return true;
        }
    }
    for (int i = 0; i < scene->plane_count; ++i) {
        const Plane plane = scene->planes[i];
        if (intersect_ray_plane(ray, XYZ(plane.normal), plane.offset) < INFINITY) {
            return true;
        }
    }
    // #region ray_any_triangle
    for (int i = 0; i < scene->triangle_count; ++i) {
        float2 barycentric;
        if (intersect_ray_triangle(ray, triangle_edges(scene, i), &barycentric) < INFINITY) {
            return true;
        }
    }
    // #endregion ray_any_triangle
    return false;
}

static bool any_hit_line(const Scene *scene, const Line line) {
    for (int i = 0; i < scene->sphere_count; ++i) {
        const Sphere sphere = scene->spheres[i];
        if (intersect_line_sphere(line, XYZ(sphere.center), sphere.radius)) {
            return true;
        }
    }
    for (int i = 0; i < scene->plane_count; ++i) {
        const Plane plane = scene->planes[i];
        if (intersect_line_plane(line, XYZ(plane.normal), plane.offset)) {
            return true;
        }
    }
    // #region line_any_triangle
    for (int i = 0; i < scene->triangle_count; ++i) {
        if (intersect_line_triangle(line, triangle_edges(scene, i))) {
            return true;
        }
    }
    // #endregion line_any_triangle
    return false;
}
// #endregion any_hit
