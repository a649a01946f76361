// SPDX-License-Identifier: MIT
// The share of the light that a dielectric reflects. `cosine` is that of the larger angle, the one on the
// side of the smaller index.
#include "ray.cl"

// #region exact
// The mean of both polarisations (Born and Wolf, Principles of Optics, 1999, section 1.5.2).
static float fresnel(const float cosine, const float ior) {
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
