// SPDX-License-Identifier: MIT
// Introduced by stage 04; extended by 10 (Fresnel's own equations): the share of the light that a
// dielectric reflects.
#include "ray.cl"

// #region fresnel
// `cosine` is that of the larger angle, the one on the side of the smaller index.
#ifndef METHOD_FRESNEL
#define METHOD_FRESNEL schlick
#endif
#define fresnel JOIN(fresnel_, METHOD_FRESNEL)
// #endregion fresnel

// #region schlick
// The reflected share (Schlick, An Inexpensive BRDF Model for Physically-based Rendering,
// 1994).
static float fresnel_schlick(const float cosine, const float ior) {
    const float root = (1.0f - ior) / (1.0f + ior);
    const float head_on = root * root;
    const float slope = 1.0f - cosine;
    const float slope_squared = slope * slope;
    return head_on + (1.0f - head_on) * slope_squared * slope_squared * slope;
}
// #endregion schlick

// #region exact
// The mean of both polarisations (Born and Wolf, Principles of Optics, 1999, section 1.5.2).
static float fresnel_exact(const float cosine, const float ior) {
    if (cosine <= 0.0f) {
        return 1.0f;  // grazing, where equal indices would give 0 / 0
    }
    const float denser = ior > 1.0f ? ior : 1.0f / ior;
    // The index beyond times the cosine there. By Snell's law, and so that no digits cancel.
    const float beyond = sqrt((denser - 1.0f) * (denser + 1.0f) + cosine * cosine);
    const float here = denser * denser * cosine;
    const float across = (cosine - beyond) / (cosine + beyond);
    const float within = (here - beyond) / (here + beyond);
    return 0.5f * (across * across + within * within);
}
// #endregion exact

// #region none
// Nothing, short of total internal reflection.
static float fresnel_none(const float cosine, const float ior) {
    return 0.0f;
}
// #endregion none
