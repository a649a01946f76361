// SPDX-License-Identifier: MIT
// #stub
// Exercise 06.2: tiles, of which every second one is mirrored.
// #solution
// Exercise 06.2, solved: the place in a tile is the distance to the nearest even number of tiles.
// #end

// kernels/texture.cl
// #region wrapped
#define REPEATS 3.0f
    const float2 tiles = REPEATS * coordinates;
// #stub
    const float2 within = tiles - floor(tiles);  // your turn
    const float2 texel = within * XY(material->texture_size) + XY(material->texture_place);
// #solution
    const float2 within = fabs(tiles - 2.0f * round(0.5f * tiles));
    // Beyond the last centre lies the border, the opposite edge; here the same texel is next.
    const float2 size = XY(material->texture_size);
    const float2 texel = clamp(within * size, (float2)(0.5f), size - 0.5f) + XY(material->texture_place);
// #end
// #endregion wrapped
