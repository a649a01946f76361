// SPDX-License-Identifier: MIT
// Introduced by stage 11, and the same for all: the mean of a picture's samples, as they come.
#include "picture.cl"

// #region accumulate
// `sum` is that of the `before` samples that came earlier, and takes in this one.
__kernel void accumulate(PICTURE mean, __global const float4 *sample, __global float4 *sum, const int before) {
    const int2 pixel = (int2)(get_global_id(0), get_global_id(1));
    const int width = (int)get_global_size(0);
    const int place = pixel.y * width + pixel.x;
    const float4 total = before > 0 ? sum[place] + sample[place] : sample[place];
    sum[place] = total;
    write_pixel(mean, width, pixel, total.xyz / (float)(before + 1));
}
// #endregion accumulate
