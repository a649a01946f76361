// SPDX-License-Identifier: MIT
// Introduced by stage 01; extended by 02 (any hit), 05 (triangles) and 06 (cut-outs): spheres and triangles, each
// of them tried.
#include "cutout.cl"
#include "scene.cl"
#include "sphere.cl"
#include "triangle.cl"

// #region closest_shape
static void closest_shape(const Scene *scene, const Ray ray, Hit *closest) {
    // #region each_sphere
    for (int i = 0; i < scene->sphere_count; ++i) {
        const Sphere sphere = scene->spheres[i];
        keep_closer(closest, intersect_ray_sphere(ray, XYZ(sphere.center), sphere.radius), SHAPE_SPHERE, i);
    }
    // #endregion each_sphere
    // #region closest_triangle
    for (int i = 0; i < scene->triangle_count; ++i) {
        float2 barycentric;
        const float distance = intersect_ray_triangle(ray, triangle_edges(scene, i), &barycentric);
        if (HAS_CUTOUTS && distance < closest->distance && is_cut_out(scene, i, barycentric)) {
            continue;
        }
        if (keep_closer(closest, distance, SHAPE_TRIANGLE, i)) {
            closest->barycentric = barycentric;
        }
    }
    // #endregion closest_triangle
}
// #endregion closest_shape

// #region any_shape
static bool any_shape_on_ray(const Scene *scene, const Ray ray) {
    for (int i = 0; i < scene->sphere_count; ++i) {
        const Sphere sphere = scene->spheres[i];
        if (intersect_ray_sphere(ray, XYZ(sphere.center), sphere.radius) < INFINITY) {
            return true;
        }
    }
    // #region ray_any_triangle
    for (int i = 0; i < scene->triangle_count; ++i) {
        float2 barycentric;
        if (intersect_ray_triangle(ray, triangle_edges(scene, i), &barycentric) < INFINITY) {
            if (HAS_CUTOUTS && is_cut_out(scene, i, barycentric)) {
                continue;
            }
            return true;
        }
    }
    // #endregion ray_any_triangle
    return false;
}

static bool any_shape_on_line(const Scene *scene, const Line line) {
    for (int i = 0; i < scene->sphere_count; ++i) {
        const Sphere sphere = scene->spheres[i];
        if (intersect_line_sphere(line, XYZ(sphere.center), sphere.radius)) {
            return true;
        }
    }
    // #region line_any_triangle
    for (int i = 0; i < scene->triangle_count; ++i) {
        if (intersect_line_triangle(line, triangle_edges(scene, i))) {
            if (HAS_CUTOUTS && is_cut_out_on_line(scene, i, line)) {
                continue;
            }
            return true;
        }
    }
    // #endregion line_any_triangle
    return false;
}
// #endregion any_shape
