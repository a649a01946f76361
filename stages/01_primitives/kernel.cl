// SPDX-License-Identifier: MIT
// Stage 01: a ray for every pixel, and the sphere or plane that it hits first.
#include "camera.cl"
#include "each_shape.cl"
#include "closest_hit.cl"
#include "picture.cl"
#include "surface.cl"

// #region normals_and_distances
// There is no light yet: a hit shows its normal as a colour, with a contour line for each
// unit of distance, fading where the lines would crowd.
static float3 normals_and_distances(const Surface *surface, const float distance) {
    const float line = 0.5f - 0.5f * cospi(2.0f * distance);
    const float darkening = 0.2f * line / (1.0f + distance * distance / 50.0f);
    return (0.5f + 0.5f * surface->normal) * (1.0f - darkening);
}
// #endregion normals_and_distances

// #region render
__kernel void render(PICTURE image, const Camera camera,
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
    float3 color = XYZ(scene.background);
    if (hit.shape != SHAPE_NONE) {
        const Surface surface = surface_at(&scene, ray, hit);
        color = normals_and_distances(&surface, hit.distance);
    }
    write_pixel(image, camera.size.x, pixel, color);
}
// #endregion render
