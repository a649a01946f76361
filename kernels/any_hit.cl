// SPDX-License-Identifier: MIT
// Introduced by stage 02: whether anything is in the way. The first thing found will do, so this is cheaper than
// the closest hit. The kernel has included each_shape.cl, or from stage 09 on tree.cl.
#include "plane.cl"
#include "scene.cl"

// #region any_hit
static bool any_hit_ray(const Scene *scene, const Ray ray) {
    for (int i = 0; i < scene->plane_count; ++i) {
        const Plane plane = scene->planes[i];
        if (intersect_ray_plane(ray, XYZ(plane.normal), plane.offset) < INFINITY) {
            return true;
        }
    }
    return any_shape_on_ray(scene, ray);
}

static bool any_hit_line(const Scene *scene, const Line line) {
    for (int i = 0; i < scene->plane_count; ++i) {
        const Plane plane = scene->planes[i];
        if (intersect_line_plane(line, XYZ(plane.normal), plane.offset)) {
            return true;
        }
    }
    return any_shape_on_line(scene, line);
}
// #endregion any_hit
