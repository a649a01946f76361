// SPDX-License-Identifier: MIT
// #stub
// Exercise 07.3: a lens over the middle of the picture.
// #solution
// Exercise 07.3, solved: within the lens, rays go through points that lie nearer to its middle.
// #end

// kernels/render.cl
// #region render_pixel
#define RADIUS 30.0f
#define POWER 3.0f
// #stub
    const Ray primary = camera_ray(&camera, pixel);  // your turn
// #solution
    const float2 middle = 0.5f * convert_float2(camera.size);
    const float2 point = convert_float2(pixel) + camera.sample;
    const bool within = length(point - middle) < RADIUS;
    Camera moved = camera;
    moved.sample = within ? middle + (point - middle) / POWER : point;
    const Ray primary = camera_ray(&moved, (int2)(0, 0));
// #end
    const float3 color = trace(&scene, primary, &counts, textures);
    write_pixel(image, camera.size.x, pixel, color);
// #endregion render_pixel
