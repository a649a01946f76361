// SPDX-License-Identifier: MIT
// What a window shows of a program that takes OpenGL's row 0 for the uppermost.

// kernels/render.cl
// #region render_pixel
    const int2 turned = (int2)(pixel.x, camera.size.y - 1 - pixel.y);
    const Ray primary = camera_ray(&camera, pixel);
    const float3 color = trace(&scene, primary, &counts, textures);
    write_pixel(image, camera.size.x, turned, color);
// #endregion render_pixel
