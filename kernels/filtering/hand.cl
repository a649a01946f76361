// SPDX-License-Identifier: MIT
// The mean of the four texels around a point, by how near each is: in float, whatever precision the device's
// filter has. OpenCL does not say how precise its weights must be (specification 1.2, section 6.12.14).
#include "scene.cl"

__constant sampler_t nearest_sampler =
    CLK_NORMALIZED_COORDS_FALSE | CLK_ADDRESS_CLAMP_TO_EDGE | CLK_FILTER_NEAREST;

// #region filtered_hand
static float3 nearest_texel(const float2 place, const float layer, TEXTURES textures) {
    return XYZ(read_imagef(textures, nearest_sampler, convert_float4((float4)(place, layer, 0.0f))));
}

static float3 filtered(const float2 texel, const float layer, TEXTURES textures) {
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
