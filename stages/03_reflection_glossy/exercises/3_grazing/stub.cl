// SPDX-License-Identifier: MIT
// Exercise 03.3: the shares of a material, to depend on the angle.

// kernels/shade.cl
// #region shade_shares
    // your turn
    const float reflected = reflected_share(&material);
    if (reflected > 0.0f) {
        spawn_reflected(stack, incoming, surface, reflected * weight, counts);
    }
    *direct_weight = (1.0f - reflected) * weight;
    return reflected < 1.0f;
// #endregion shade_shares
