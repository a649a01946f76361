// SPDX-License-Identifier: MIT
// Introduced by stage 01; extended by 07 (an image): where a pixel's colour goes.
#include "real.cl"

// #region write_pixel
#if PICTURE_IS_IMAGE
// An image that may be an OpenGL texture: the window shows what is written here, with no copy.
#define PICTURE __write_only image2d_t
static void write_pixel(PICTURE image, const int width, const int2 pixel, const float3 color) {
    write_imagef(image, pixel, convert_float4((float4)(color, 1.0f)));
}
#else
// #region picture_buffer
#define PICTURE __global Single4 *
static void write_pixel(PICTURE image, const int width, const int2 pixel, const float3 color) {
    image[pixel.y * width + pixel.x] = convert_float4((float4)(color, 1.0f));
}
// #endregion picture_buffer
#endif
// #endregion write_pixel
