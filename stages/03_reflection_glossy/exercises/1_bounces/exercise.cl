// SPDX-License-Identifier: MIT
// #stub
// Exercise 03.1: how long each pixel's path is.
// #solution
// Exercise 03.1, solved: the counts of a work-item are those of its pixel.
// #end

// kernels/render.cl
// #region render
// From black over violet and red to yellow.
static float3 heat(const float share) {
    return (float3)(sqrt(share), share * share * share, max(sin(2.0f * PI * share), 0.0f));
}

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
    RayCounts counts = {0, 0, 0, 0, 0, 0};
    const Ray primary = camera_ray(&camera, pixel);
// #stub
    const float3 color = trace(&scene, primary, &counts, textures);  // your turn
// #solution
    trace(&scene, primary, &counts, textures);
    const float3 color =
        counts.dropped > 0 ? (float3)(1.0f) : heat((float)counts.reflection / (float)MAX_DEPTH);
// #end
    write_pixel(image, camera.size.x, pixel, color);
    add_ray_counts(&ray_counts[pixel.y], counts);
}
// #endregion render
