// SPDX-License-Identifier: MIT
// Core exercise 02 direct_light: what a surface gets of one light.

// kernels/diffuse.cl
// #region add_light
        // Given are cosine and illumination; scene, light, surface and counts.
        sum += illumination.irradiance;  // your turn
// #endregion add_light
