// SPDX-License-Identifier: MIT
// The curves between light and a picture's values.
#include "transfer_curves.h"

__kernel void curves(__global float4 *results, __global const float *values) {
    const size_t i = get_global_id(0);
    results[i] = (float4)(srgb_encode(values[i]), srgb_decode(values[i]), power_encode(values[i]),
                          power_decode(values[i]));
}
