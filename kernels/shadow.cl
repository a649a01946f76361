// SPDX-License-Identifier: MIT
// Introduced by stage 02: whether the light arrives. The kernel has included any_hit_ray and any_hit_line.
#include "light.cl"

// #region in_shadow
// A point light is at the end of a line: what stands behind it casts no shadow. A
// directional light has no place, and its shadow ray no end.
static bool in_shadow(const Scene *scene, const Light light, const float3 origin) {
    if (is_point(light)) {
        const Line line = {origin, XYZ(light.as.point.position)};
        return any_hit_line(scene, line);
    }
    const Ray ray = {origin, -XYZ(light.as.directional.direction)};
    return any_hit_ray(scene, ray);
}
// #endregion in_shadow
