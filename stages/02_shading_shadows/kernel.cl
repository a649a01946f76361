// SPDX-License-Identifier: MIT
// Stage 02: diffuse shading under point and directional lights, with hard shadows.
#include "camera.cl"
#include "each_shape.cl"  // extended: any of them
#include "closest_hit.cl"
#include "picture.cl"
#include "any_hit.cl"             // new: whether anything is in the way
#include "diffuse.cl"             // new: the sum over the lights
#include "light.cl"               // new: how much light arrives
#include "origin.cl"              // new: where a shadow ray starts
#include "origin/error_bound.cl"  // new: how far off the surface that is
#include "ray_counts.cl"          // new: how many rays a picture took
#include "shadow.cl"              // new: whether the light arrives
#include "plane.cl"               // extended: lines
#include "ray.cl"                 // extended: lines; what a surface is made of
#include "scene.cl"               // extended: materials and lights
#include "scene_types.h"          // extended: materials and lights
#include "sphere.cl"              // new: lines
#include "surface.cl"             // extended: what it is made of, and where its rays start

// #region render
__kernel void render(PICTURE image, __global RayCounts *ray_counts, const Camera camera,
#include "scene_parameters.inc"
) {
    const int2 pixel = (int2)(get_global_id(0), get_global_id(1));
    if (pixel.x >= camera.size.x || pixel.y >= camera.size.y) {
        return;
    }
    const Scene scene = {
#include "scene_members.inc"
    };
    const Ray ray = camera_ray(&camera, pixel);
    const Hit hit = closest_hit(&scene, ray);
    RayCounts counts = {0, 0, 0, 0, 0, 0};
    float3 color = XYZ(scene.background);
    if (hit.shape != SHAPE_NONE) {
        const Surface surface = surface_at(&scene, ray, hit);
        // #region shade_hit
        const float3 reflectance = XYZ(scene.materials[surface.material].color);
        color = reflectance * direct_light(&scene, &surface, &counts);
        // #endregion shade_hit
    }
    write_pixel(image, camera.size.x, pixel, color);
    add_ray_counts(&ray_counts[pixel.y], counts);
}
// #endregion render
