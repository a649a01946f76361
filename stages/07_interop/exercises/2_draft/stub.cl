// SPDX-License-Identifier: MIT
// Exercise 07.2: one ray for each block of pixels.

// kernels/render.cl
// #region render_pixel
#define BLOCK 4
    const Ray primary = camera_ray(&camera, pixel);  // your turn
    const float3 color = trace(&scene, primary, &counts, textures);
    write_pixel(image, camera.size.x, pixel, color);
// #endregion render_pixel
