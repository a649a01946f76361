// SPDX-License-Identifier: MIT
// #stub
// Exercise 08.3: five codes a channel, and as much light in each block of pixels as before.
// #solution
// Exercise 08.3, solved: the share of pixels that show the upper code is worked out in light.
// #end

// kernels/picture.cl
// #region picture_buffer
#include "transfer_curves.h"

#define PICTURE __global Single4 *
#define STEPS 4.0f  // from code to code up to white

// Of a pixel's place in a block of 8 by 8, one of 64 thresholds between 0 and 1, each once: bits of x ^ y and y,
// interleaved from the lowest on.
static float bayer(const int2 pixel) {
    int order = 0;
    for (int bit = 0; bit < 3; ++bit) {
        const int x = (pixel.x >> bit) & 1;
        const int y = (pixel.y >> bit) & 1;
        order = 4 * order + 2 * (x ^ y) + y;
    }
    return ((float)order + 0.5f) / 64.0f;
}

static float dithered(const float light, const float threshold) {
// #stub
    const float code = floor(STEPS * srgb_encode(light) + 0.5f);  // your turn
    return srgb_decode(code / STEPS);
// #solution
    const float below = min(floor(STEPS * srgb_encode(light)), STEPS - 1.0f);
    const float low = srgb_decode(below / STEPS);
    const float high = srgb_decode((below + 1.0f) / STEPS);
    return light - low > threshold * (high - low) ? high : low;
// #end
}

static void write_pixel(PICTURE image, const int width, const int2 pixel, const float3 color) {
    const float threshold = bayer(pixel);
    image[pixel.y * width + pixel.x] =
        (float4)(dithered(color.x, threshold), dithered(color.y, threshold),
                 dithered(color.z, threshold), 1.0f);
}
// #endregion picture_buffer
