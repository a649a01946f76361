// SPDX-License-Identifier: MIT
// Introduced by stage 03; extended by 04 (media), 05 (meshes), 06 (textures) and 09 (a tree): the kernel, one
// work-item a pixel.
#include "camera.cl"
#include "picture.cl"
#include "ray_counts.cl"
#include "trace.cl"

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
    RayCounts counts = {0, 0, 0, 0, 0, 0};
    // #region render_pixel
    const Ray primary = camera_ray(&camera, pixel);
    const float3 color = trace(&scene, primary, &counts, textures);
    write_pixel(image, camera.size.x, pixel, color);
    // #endregion render_pixel
    add_ray_counts(&ray_counts[pixel.y], counts);
}
// #endregion render
