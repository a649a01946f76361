// SPDX-License-Identifier: MIT
// Introduced by stage 02: whether the light arrives.
#include "any_hit.cl"

// #region in_shadow
// A point light is at the end of a line: what stands behind it casts no shadow. A
// directional light has no place, and its shadow ray no end.
#if LIGHT_COUNT > 0
static bool in_shadow(const Scene *scene, const Light light, const float3 origin) {
#if HAS_POINT_LIGHT
    if (light.type == LIGHT_POINT) {
        const Line line = {origin, XYZ(light.as.point.position)};
        return any_hit_line(scene, line);
    }
#endif
#if HAS_DIRECTIONAL_LIGHT
    const Ray ray = {origin, -XYZ(light.as.directional.direction)};
    return any_hit_ray(scene, ray);
#else
    return false;
#endif
}
#endif
// #endregion in_shadow
