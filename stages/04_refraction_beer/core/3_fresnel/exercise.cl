// SPDX-License-Identifier: MIT
// Core exercise 04 fresnel: how much glass reflects.

// kernels/fresnel/schlick.cl
// #region schlick
// The share that is reflected, from 0 to 1.
static float fresnel(const float cosine, const float ior) {
    return 0.0f;  // your turn
}
// #endregion schlick
