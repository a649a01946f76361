// SPDX-License-Identifier: MIT
// Introduced by stage 06: reading a picture.
#include "scene.cl"

#if HAS_TEXTURES
// #region filtered
// OpenCL 1.2 hands textures over as one array of images of one size (paper, section 7). Each
// picture lies in the upper left corner of its layer, inside a border of one texel copied from its
// opposite edge, so that the filter blends across the wrap. Coordinates are in texels: PoCL 3.1
// scales the layer too when they are normalised, and reads the wrong one.
__constant sampler_t texel_sampler =
    CLK_NORMALIZED_COORDS_FALSE | CLK_ADDRESS_CLAMP_TO_EDGE | CLK_FILTER_LINEAR;

// The mean of the four texels around a point, by how near each is.
#ifndef METHOD_FILTERING
#define METHOD_FILTERING sampler
#endif
#define filtered JOIN(filtered_, METHOD_FILTERING)

// #region filtered_sampler
static float3 filtered_sampler(const float2 texel, const float layer, TEXTURES textures) {
    return XYZ(read_imagef(textures, texel_sampler, convert_float4((float4)(texel, layer, 0.0f))));
}
// #endregion filtered_sampler

// In float, whatever precision the device's filter has: OpenCL does not say how precise its
// weights must be (specification 1.2, section 6.12.14).
__constant sampler_t nearest_sampler =
    CLK_NORMALIZED_COORDS_FALSE | CLK_ADDRESS_CLAMP_TO_EDGE | CLK_FILTER_NEAREST;

// #region filtered_hand
static float3 nearest_texel(const float2 place, const float layer, TEXTURES textures) {
    return XYZ(
        read_imagef(textures, nearest_sampler, convert_float4((float4)(place, layer, 0.0f))));
}

static float3 filtered_hand(const float2 texel, const float layer, TEXTURES textures) {
    const float2 low = floor(texel - 0.5f);
    const float2 share = texel - 0.5f - low;
    const float2 near = low + 0.5f;
    const float2 far = near + 1.0f;
    const float3 a = nearest_texel(near, layer, textures);
    const float3 b = nearest_texel((float2)(far.x, near.y), layer, textures);
    const float3 c = nearest_texel((float2)(near.x, far.y), layer, textures);
    const float3 d = nearest_texel(far, layer, textures);
    return mix(mix(a, b, share.x), mix(c, d, share.x), share.y);
}
// #endregion filtered_hand
// #endregion filtered

// #region texture_color
static float3 texture_color(const Material *material, const float2 coordinates, TEXTURES textures) {
    if (material->texture < 0) {
        return (float3)(1.0f);
    }
    // #region wrapped
    const float2 wrapped = coordinates - floor(coordinates);
    const float2 texel = wrapped * XY(material->texture_size) + 1.0f;
    // #endregion wrapped
    return filtered(texel, convert_float(material->texture), textures);
}
// #endregion texture_color
#else
static float3 texture_color(const Material *material, const float2 coordinates, TEXTURES textures) {
    return (float3)(1.0f);
}
#endif
