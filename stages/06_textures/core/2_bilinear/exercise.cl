// SPDX-License-Identifier: MIT
// Core exercise 06 bilinear: a colour between four texels.

// kernels/filtering/hand.cl
// #region filtered_hand
static float3 nearest_texel(const float2 place, const float layer, TEXTURES textures) {
    return XYZ(read_imagef(textures, nearest_sampler, convert_float4((float4)(place, layer, 0.0f))));
}

static float3 filtered(const float2 texel, const float layer, TEXTURES textures) {
    return nearest_texel(floor(texel) + 0.5f, layer, textures);  // your turn
}
// #endregion filtered_hand
