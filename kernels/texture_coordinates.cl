// SPDX-License-Identifier: MIT
// Introduced by stage 06: where on a picture a point of a sphere lies.
#include "ray.cl"

// #region sphere_texture_coordinates
// Longitude and latitude of `normal`: u to the right seen from outside, v down from the north pole.
// The paper (section 7) has pi twice too large under v, and takes u from x and y, of which y is the
// axis; the two horizontal components are x and z. At a pole, rounding can push y past 1, where
// asin is NaN.
static float2 sphere_texture_coordinates(const float3 normal) {
    const float u = 0.5f + atan2(normal.x, normal.z) / (2.0f * PI);
    const float v = 0.5f - asin(clamp(normal.y, (float)(-1.0f), (float)(1.0f))) / PI;
    return (float2)(u, v);
}
// #endregion sphere_texture_coordinates
