// SPDX-License-Identifier: MIT
// Introduced by stage 02; extended by 05 (triangles): whether anything is in the way. The first
// thing found will do, so this is cheaper than the closest hit.
#include "origin.cl"
#include "plane.cl"
#include "scene.cl"
#include "sphere.cl"
#if TRIANGLE_COUNT > 0
#include "triangle.cl"
#endif

// #region any_hit
#if HAS_DIRECTIONAL_LIGHT
static bool any_hit_ray(const Scene *scene, const Ray ray) {
#if SPHERE_COUNT > 0
    for (int i = 0; i < SPHERE_COUNT; ++i) {
        const Sphere sphere = scene->spheres[i];
        if (intersect_ray_sphere(ray, XYZ(sphere.center), sphere.radius) < INFINITY) {
            return true;
        }
    }
#endif
#if PLANE_COUNT > 0
    for (int i = 0; i < PLANE_COUNT; ++i) {
        const Plane plane = scene->planes[i];
        if (intersect_ray_plane(ray, XYZ(plane.normal), plane.offset) < INFINITY) {
            return true;
        }
    }
#endif
#if TRIANGLE_COUNT > 0
    // #region ray_any_triangle
    for (int i = 0; i < TRIANGLE_COUNT; ++i) {
        float2 barycentric;
        if (intersect_ray_triangle(ray, triangle_edges(scene, i), &barycentric) < INFINITY) {
            return true;
        }
    }
    // #endregion ray_any_triangle
#endif
    return false;
}
#endif

#if HAS_POINT_LIGHT
static bool any_hit_line(const Scene *scene, const Line line) {
#if SPHERE_COUNT > 0
    for (int i = 0; i < SPHERE_COUNT; ++i) {
        const Sphere sphere = scene->spheres[i];
        if (intersect_line_sphere(line, XYZ(sphere.center), sphere.radius)) {
            return true;
        }
    }
#endif
#if PLANE_COUNT > 0
    for (int i = 0; i < PLANE_COUNT; ++i) {
        const Plane plane = scene->planes[i];
        if (intersect_line_plane(line, XYZ(plane.normal), plane.offset)) {
            return true;
        }
    }
#endif
#if TRIANGLE_COUNT > 0
    // #region line_any_triangle
    for (int i = 0; i < TRIANGLE_COUNT; ++i) {
        if (intersect_line_triangle(line, triangle_edges(scene, i))) {
            return true;
        }
    }
    // #endregion line_any_triangle
#endif
    return false;
}
#endif
// #endregion any_hit
