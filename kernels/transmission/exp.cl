// SPDX-License-Identifier: MIT
// Introduced by stage 04: the share of the light that is left after a way through an absorbing medium
// (Beer's law).
#include "ray.cl"

// #region transmittance
static float3 transmittance(const float3 absorption, const float distance) {
    return exp(-absorption * distance);
}
// #endregion transmittance
