// SPDX-License-Identifier: MIT
// Core exercise 06 coordinates: where on a picture a point of a sphere lies.

// kernels/texture_coordinates.cl
// #region sphere_texture_coordinates
// u to the right seen from outside, v down from the north pole; both from 0 to 1.
static float2 sphere_texture_coordinates(const float3 normal) {
    return (float2)(0.5f + 0.5f * normal.x, 0.5f - 0.5f * normal.y);  // your turn
}
// #endregion sphere_texture_coordinates
