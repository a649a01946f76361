// SPDX-License-Identifier: MIT
// Exercise 07.3: a lens over the middle of the picture.

// kernels/render.cl
// #region render_pixel
#define RADIUS 30.0f
#define POWER 3.0f
    const Ray primary = camera_ray(&camera, pixel);  // your turn
    const float3 color = trace(&scene, primary, &counts, textures);
    write_pixel(image, camera.size.x, pixel, color);
// #endregion render_pixel
