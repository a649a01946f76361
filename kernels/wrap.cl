// SPDX-License-Identifier: MIT
// Introduced by stage 06: what lies beyond the edges of a picture.
#include "scene.cl"

// #region wrap
static float wrap_axis(const float coordinate, const uchar type) {
    if (type == WRAP_CLAMP) {
        return clamp(coordinate, (float)(0.0f), (float)(1.0f));
    }
    const float in_two = coordinate - 2.0f * floor(0.5f * coordinate);  // a picture and its mirror image
    return type == WRAP_MIRROR ? MIN(in_two, 2.0f - in_two) : coordinate - floor(coordinate);
}

// The place on the picture, 0 to 1 each way.
static float2 wrap(const Material *material, const float2 coordinates) {
    if (HAS_WRAPS) {
        return (float2)(wrap_axis(coordinates.x, material->wrap_u), wrap_axis(coordinates.y, material->wrap_v));
    }
    return coordinates - floor(coordinates);
}
// #endregion wrap
