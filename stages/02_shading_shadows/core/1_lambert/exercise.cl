// SPDX-License-Identifier: MIT
// Core exercise 02 lambert: light that comes in at a slant.

// kernels/diffuse.cl
// #region lambert
        float cosine = 1.0f;  // your turn
// #endregion lambert
