// SPDX-License-Identifier: MIT
// Exercise 03.3: the shares of a material, to depend on the angle.

// kernels/shade.cl
// #region shade_shares
    // your turn
    const float reflected = reflected_share(&material);
    if (reflected > 0.0f) {
        spawn_reflected(stack, incoming, surface, reflected * weight, counts);
    }
    const float diffuse = diffuse_share(&material);
    *direct_weight = diffuse * weight;
    return diffuse > 0.0f;
// #endregion shade_shares
