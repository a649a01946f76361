// SPDX-License-Identifier: MIT
// Introduced by stage 06: reading a picture, with the device's own linear filter.
#include "scene.cl"

// #region texture_color
// OpenCL 1.2 hands textures over as one array of images of one size (paper, section 7). Each
// picture lies in the upper left corner of its layer, inside a border of one texel copied from its
// opposite edge, so that the filter blends across the wrap. Coordinates are in texels: PoCL 3.1
// scales the layer too when they are normalised, and reads the wrong one.
__constant sampler_t texel_sampler =
    CLK_NORMALIZED_COORDS_FALSE | CLK_ADDRESS_CLAMP_TO_EDGE | CLK_FILTER_LINEAR;

static float3 texture_color(const Material *material, const float2 coordinates TEXTURE_PARAMETER) {
    if (material->texture < 0) {
        return (float3)(1.0f);
    }
    const float2 wrapped = coordinates - floor(coordinates);
    const float2 texel = wrapped * material->texture_size + 1.0f;
    const float4 position = (float4)(texel, convert_float(material->texture), 0.0f);
    return read_imagef(textures, texel_sampler, position).xyz;
}
// #endregion texture_color
