// SPDX-License-Identifier: MIT
// Core exercise 03 reflect: the direction that a mirror sends on.

// kernels/reflection.cl
// #region law_of_reflection
// As long as `direction`; `normal` may be on either side of the surface.
static float3 reflect(const float3 direction, const float3 normal) {
    return -direction;  // your turn
}
// #endregion law_of_reflection
