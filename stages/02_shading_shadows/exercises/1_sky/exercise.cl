// SPDX-License-Identifier: MIT
// #stub
// Exercise 02.1: light from the sky and the ground.
// #solution
// Exercise 02.1, solved: the integral of the cosine over the part of the hemisphere that is sky has this closed form.
// #end

// kernels/diffuse.cl
// #region without_lights
#define SKY (float3)(0.22f, 0.3f, 0.42f)
#define GROUND (float3)(0.16f, 0.12f, 0.08f)
// #stub
    float3 sum = (float3)(0.0f);  // your turn
// #solution
    const float sky_share = 0.5f + 0.5f * surface->normal.y;
    float3 sum = mix(GROUND, SKY, sky_share);
// #end
// #endregion without_lights
