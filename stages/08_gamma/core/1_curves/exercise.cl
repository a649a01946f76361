// SPDX-License-Identifier: MIT
// Core exercise 08 curves: from light to values and back.

// kernels/transfer_curves.h
// #region srgb
TRANSFER float srgb_encode(float light) {
    return within_screen(light);  // your turn
}

TRANSFER float srgb_decode(float value) {
    return within_screen(value);  // your turn
}
// #endregion srgb
