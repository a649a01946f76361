// SPDX-License-Identifier: MIT
// Exercise 06.2: tiles, of which every second one is mirrored.

// kernels/texture.cl
// #region wrapped
#define REPEATS 3.0f
    const float2 tiles = REPEATS * coordinates;
    const float2 within = tiles - floor(tiles);  // your turn
    const float2 texel = within * XY(material->texture_size) + 1.0f;
// #endregion wrapped
