// SPDX-License-Identifier: MIT
// Introduced by stage 01: what a ray hits first. The kernel has included each_shape.cl, or from stage 09 on
// tree.cl.
#include "plane.cl"
#include "scene.cl"

// #region closest_hit
static Hit closest_hit(const Scene *scene, const Ray ray) {
    Hit closest;
    closest.distance = INFINITY;
    closest.shape = SHAPE_NONE;
    // #region each_plane
    for (int i = 0; i < scene->plane_count; ++i) {
        const Plane plane = scene->planes[i];
        keep_closer(&closest, intersect_ray_plane(ray, XYZ(plane.normal), plane.offset), SHAPE_PLANE, i);
    }
    // #endregion each_plane
    closest_shape(scene, ray, &closest);
    return closest;
}
// #endregion closest_hit
