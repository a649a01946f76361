// SPDX-License-Identifier: MIT
// Exercise 02.1: light from the sky and the ground.

// kernels/diffuse.cl
// #region without_lights
#define SKY (float3)(0.22f, 0.3f, 0.42f)
#define GROUND (float3)(0.16f, 0.12f, 0.08f)
    float3 sum = (float3)(0.0f);  // your turn
// #endregion without_lights
