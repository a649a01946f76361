// SPDX-License-Identifier: MIT
// What is shown of a texture in which the next frame has been begun: its upper part is new, the rest of the frame before.

// kernels/render.cl
// #region render_pixel
    Camera moved = camera;
    moved.position += pixel.y < camera.size.y * 11 / 20 ? 200.0f * camera.right : (float4)(0.0f);
    const Ray primary = camera_ray(&moved, pixel);
    const float3 color = trace(&scene, primary, &counts, textures);
    write_pixel(image, camera.size.x, pixel, color);
// #endregion render_pixel
