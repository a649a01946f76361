// SPDX-License-Identifier: MIT
// Exercise 07.1, solved: on the row and the column through the middle, the picture's colour turned round.

// kernels/render.cl
// #region render_pixel
#define ARM 12
    const Ray primary = camera_ray(&camera, pixel);
    const float3 color = trace(&scene, primary, &counts, textures);
    const int2 off = pixel - camera.size / 2;
    const bool marked = (off.x == 0 && abs(off.y) <= ARM) || (off.y == 0 && abs(off.x) <= ARM);
    const float3 opposite = 1.0f - clamp(color, 0.0f, 1.0f);
    write_pixel(image, camera.size.x, pixel, marked ? opposite : color);
// #endregion render_pixel
