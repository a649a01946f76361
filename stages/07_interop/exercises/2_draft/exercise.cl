// SPDX-License-Identifier: MIT
// #stub
// Exercise 07.2: one ray for each block of pixels.
// #solution
// Exercise 07.2, solved: the work-item of a block's first pixel traces, and fills the block.
// #end

// kernels/render.cl
// #region render_pixel
#define BLOCK 4
// #stub
    const Ray primary = camera_ray(&camera, pixel);  // your turn
    const float3 color = trace(&scene, primary, &counts, textures);
    write_pixel(image, camera.size.x, pixel, color);
// #solution
    if (pixel.x % BLOCK != 0 || pixel.y % BLOCK != 0) {
        return;
    }
    const Ray primary = camera_ray(&camera, pixel);
    const float3 color = trace(&scene, primary, &counts, textures);
    const int2 end = min(pixel + BLOCK, camera.size);
    for (int y = pixel.y; y < end.y; ++y) {
        for (int x = pixel.x; x < end.x; ++x) {
            write_pixel(image, camera.size.x, (int2)(x, y), color);
        }
    }
// #end
// #endregion render_pixel
