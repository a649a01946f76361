// SPDX-License-Identifier: MIT
// Introduced by stage 04: the share of the light that a dielectric reflects. `cosine` is that of the larger
// angle, the one on the side of the smaller index.
#include "ray.cl"

// #region schlick
// The reflected share (Schlick, An Inexpensive BRDF Model for Physically-based Rendering,
// 1994).
static float fresnel(const float cosine, const float ior) {
    const float root = (1.0f - ior) / (1.0f + ior);
    const float head_on = root * root;
    const float slope = 1.0f - cosine;
    const float slope_squared = slope * slope;
    return head_on + (1.0f - head_on) * slope_squared * slope_squared * slope;
}
// #endregion schlick
