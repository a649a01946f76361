// SPDX-License-Identifier: MIT
// #stub
// Exercise 07.1: a cross-hair in the middle of the picture.
// #solution
// Exercise 07.1, solved: on the row and the column through the middle, the picture's colour turned round.
// #end

// kernels/render.cl
// #region render_pixel
#define ARM 12
    const Ray primary = camera_ray(&camera, pixel);
    const float3 color = trace(&scene, primary, &counts, textures);
    const int2 off = pixel - camera.size / 2;
// #stub
    const bool marked = false;  // your turn: by `off`
    write_pixel(image, camera.size.x, pixel, marked ? (float3)(0.0f) : color);
// #solution
    const bool marked = (off.x == 0 && abs(off.y) <= ARM) || (off.y == 0 && abs(off.x) <= ARM);
    const float3 opposite = 1.0f - clamp(color, 0.0f, 1.0f);
    write_pixel(image, camera.size.x, pixel, marked ? opposite : color);
// #end
// #endregion render_pixel
