// SPDX-License-Identifier: MIT
// Introduced by stage 06: reading a picture.
#include "scene.cl"
#include "wrap.cl"

// #region filtered
// OpenCL 1.2 hands textures over as one array of images of one size (paper, section 7). Each
// picture has a place on a layer, inside a border of one texel that continues it beyond its edges, so
// that the filter blends across the wrap. Coordinates are in texels: PoCL 3.1 scales the layer too when
// they are normalised, and reads the wrong one.
#include "filtering/sampler.cl"
// #endregion filtered

// #region texture_color
static float3 texture_color(const Material *material, const float2 coordinates, TEXTURES textures) {
    if (material->texture < 0) {
        return (float3)(1.0f);
    }
    // #region wrapped
    const float2 wrapped = wrap(material, coordinates);
    const float2 texel = wrapped * XY(material->texture_size) + XY(material->texture_place);
    // #endregion wrapped
    return filtered(texel, convert_float(material->texture), textures);
}
// #endregion texture_color
