// SPDX-License-Identifier: MIT
// Exercise 07.1: a cross-hair in the middle of the picture.

// kernels/render.cl
// #region render_pixel
#define ARM 12
    const Ray primary = camera_ray(&camera, pixel);
    const float3 color = trace(&scene, primary, &counts, textures);
    const int2 off = pixel - camera.size / 2;
    const bool marked = false;  // your turn: by `off`
    write_pixel(image, camera.size.x, pixel, marked ? (float3)(0.0f) : color);
// #endregion render_pixel
