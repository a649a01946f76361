// SPDX-License-Identifier: MIT
// A scene without textures has nothing to filter. The host chooses this file for it.
#include "scene.cl"

static float3 filtered(const float2 texel, const float layer, TEXTURES textures) {
    return (float3)(1.0f);
}
