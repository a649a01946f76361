// SPDX-License-Identifier: MIT
// Introduced by stage 02: diffuse shading, the light that a surface gets straight from lights.
#include "light.cl"
#include "origin.cl"
#include "ray_counts.cl"
#include "shadow.cl"
#include "terminator/hanika.cl"

// #region direct_light
// The sum over the lights that the point sees, of Lambert's cosine times irradiance (the 1/pi of
// a diffuse surface is taken to be in the lights).
static float3 direct_light(const Scene *scene, const Surface *surface, RayCounts *counts) {
    // #region without_lights
    float3 sum = (float3)(0.0f);
    // #endregion without_lights
    for (int i = 0; i < scene->light_count; ++i) {
        const Light light = scene->lights[i];
        const Illumination illumination = light_at(light, surface->position);
        // #region lambert
        float cosine = dot(surface->normal, illumination.direction);
        // #endregion lambert
        if (HAS_SMOOTH_MESH) {
            cosine *= shadowing(surface, illumination.direction, cosine);
        }
        // #region add_light
        if (cosine > 0.0f) {
            ++counts->shadow;
            if (!in_shadow(scene, light, offset_ray_origin(surface, illumination.direction))) {
                sum += cosine * illumination.irradiance;
            }
        }
        // #endregion add_light
    }
    return sum;
}
// #endregion direct_light
