// SPDX-License-Identifier: MIT
// Core exercise 04 refract: where a ray goes in glass.

// kernels/dielectric.cl
// #region refract
// Snell's law in vectors; `ratio` is the index of refraction on the side of `normal` over that
// beyond. False where there is no such direction: total internal reflection.
static bool refract(const float3 direction, const float3 normal, const float ratio, float3 *refracted) {
    *refracted = direction;  // your turn
    return true;
}
// #endregion refract
