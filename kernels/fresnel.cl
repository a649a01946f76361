// SPDX-License-Identifier: MIT
// Introduced by stage 10: the share that Fresnel's equations reflect, which Schlick approximates.
#include "scene_types.h"

// #region fresnel
// The mean of both polarisations (Born and Wolf, Principles of Optics, 1999, section 1.5.2). As with
// schlick, `cosine` is that of the larger angle, on the side of the smaller index.
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
// #endregion fresnel
