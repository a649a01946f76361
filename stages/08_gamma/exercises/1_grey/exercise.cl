// SPDX-License-Identifier: MIT
// #stub
// Exercise 08.1: the picture in grey.
// #solution
// Exercise 08.1, solved: a pixel's luminance in all three channels.
// #end

// kernels/picture.cl
// #region picture_buffer
#define PICTURE __global Single4 *
#define LUMINANCE (float3)(0.2126f, 0.7152f, 0.0722f)

static void write_pixel(PICTURE image, const int width, const int2 pixel, const float3 color) {
// #stub
    image[pixel.y * width + pixel.x] = (float4)(color, 1.0f);  // your turn
// #solution
    image[pixel.y * width + pixel.x] = (float4)((float3)(dot(color, LUMINANCE)), 1.0f);
// #end
}
// #endregion picture_buffer
