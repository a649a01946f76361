// SPDX-License-Identifier: MIT
// Introduced by stage 06: the mean of the four texels around a point, by how near each is, from the device's
// own filter.
#include "scene.cl"

// #region filtered_sampler
__constant sampler_t texel_sampler = CLK_NORMALIZED_COORDS_FALSE | CLK_ADDRESS_CLAMP_TO_EDGE | CLK_FILTER_LINEAR;

static float3 filtered(const float2 texel, const float layer, TEXTURES textures) {
    return XYZ(read_imagef(textures, texel_sampler, convert_float4((float4)(texel, layer, 0.0f))));
}
// #endregion filtered_sampler
