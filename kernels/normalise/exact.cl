// SPDX-License-Identifier: MIT
// Introduced by stage 01: the direction of a vector.
#include "real.cl"

// #region unit
static float3 unit(const float3 a) {
    return normalize(a);
}
// #endregion unit
