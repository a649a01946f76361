// SPDX-License-Identifier: MIT
// Exercise 06.4: a cubic filter.

// kernels/texture.cl
// #region texture_color
// Of four texels in a row, for a place that is t beyond the second.
static float4 cubic_weights(const float t) {
    return (float4)(0.0f, 1.0f, 0.0f, 0.0f);  // your turn
}

static float3 texture_color(const Material *material, const float2 coordinates, TEXTURES textures) {
    if (material->texture < 0) {
        return (float3)(1.0f);
    }
    const float2 wrapped = coordinates - floor(coordinates);
    const float2 texel = wrapped * XY(material->texture_size) + 1.0f;
    return nearest_texel(texel, convert_float(material->texture), textures);  // your turn
}
// #endregion texture_color
