// SPDX-License-Identifier: MIT
// Exercise 02.4: lamps that have a size, and the soft shadows that they cast.

// kernels/diffuse.cl
// #region direct_light
#define LAMP_RADIUS 0.7f
#define LAMP_POINTS 64

// The share of the light, which lies in a direction of unit length, that is seen from `origin`.
static float lit_share(const Scene *scene, const Light light, const float3 origin,
                       const float3 direction, RayCounts *counts) {
    ++counts->shadow;  // your turn
    return in_shadow(scene, light, origin) ? 0.0f : 1.0f;
}

static float3 direct_light(const Scene *scene, const Surface *surface, RayCounts *counts) {
    float3 sum = (float3)(0.0f);
    for (int i = 0; i < scene->light_count; ++i) {
        const Light light = scene->lights[i];
        const Illumination illumination = light_at(light, surface->position);
        const float cosine = dot(surface->normal, illumination.direction);
        if (cosine > 0.0f) {
            const float3 origin = offset_ray_origin(surface, illumination.direction);
            const float share = lit_share(scene, light, origin, illumination.direction, counts);
            sum += share * cosine * illumination.irradiance;
        }
    }
    return sum;
}
// #endregion direct_light
