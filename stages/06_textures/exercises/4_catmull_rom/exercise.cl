// SPDX-License-Identifier: MIT
// #stub
// Exercise 06.4: a cubic filter.
// #solution
// Exercise 06.4, solved: cubic_weights across and down, of 4 by 4 texels.
// #end

// kernels/texture.cl
// #region texture_color
__constant sampler_t nearest_sampler =
    CLK_NORMALIZED_COORDS_FALSE | CLK_ADDRESS_CLAMP_TO_EDGE | CLK_FILTER_NEAREST;

static float3 nearest_texel(const float2 place, const float layer, TEXTURES textures) {
    return XYZ(
        read_imagef(textures, nearest_sampler, convert_float4((float4)(place, layer, 0.0f))));
}

// #stub
// Of four texels in a row, for a place that is t beyond the second.
static float4 cubic_weights(const float t) {
    return (float4)(0.0f, 1.0f, 0.0f, 0.0f);  // your turn
}
// #solution
// Of four texels in a row, for a place that is t beyond the second (Catmull and Rom, A Class of Local
// Interpolating Splines, 1974): a cubic through both in the middle, whose slopes are those of the chords
// around.
static float4 cubic_weights(const float t) {
    const float rest = 1.0f - t;
    return 0.5f * (float4)(-t * rest * rest, (3.0f * t - 5.0f) * t * t + 2.0f,
                           (3.0f * rest - 5.0f) * rest * rest + 2.0f, -rest * t * t);
}
// #end

static float3 texture_color(const Material *material, const float2 coordinates, TEXTURES textures) {
    if (material->texture < 0) {
        return (float3)(1.0f);
    }
// #stub
    const float2 wrapped = coordinates - floor(coordinates);
    const float2 texel = wrapped * XY(material->texture_size) + XY(material->texture_place);
    return nearest_texel(texel, convert_float(material->texture), textures);  // your turn
// #solution
    const float2 size = XY(material->texture_size);
    const float2 first = XY(material->texture_place) + 0.5f;
    const float2 place = coordinates * size - 0.5f;
    const float2 low = floor(place);
    const float4 across = cubic_weights(place.x - low.x);
    const float4 down = cubic_weights(place.y - low.y);
    const float weights[2][4] = {{across.x, across.y, across.z, across.w},
                                 {down.x, down.y, down.z, down.w}};
    float3 sum = (float3)(0.0f);
    for (int j = 0; j < 4; ++j) {
        for (int i = 0; i < 4; ++i) {
            const float2 index = low + (float2)(i - 1, j - 1);
            const float2 texel = index - size * floor(index / size);  // the border is too narrow
            sum += weights[0][i] * weights[1][j]
                   * nearest_texel(first + texel, convert_float(material->texture), textures);
        }
    }
    return clamp(sum, 0.0f, 1.0f);  // no surface sends on more light than it gets, nor less than none
// #end
}
// #endregion texture_color
