// SPDX-License-Identifier: MIT
// Exercise 02.3: rough instead of ideally diffuse surfaces.

// kernels/diffuse.cl
// #region direct_light
#define SIGMA 0.6f

// Instead of Lambert's cosine.
static float rough(const float3 normal, const float3 to_light, const float3 to_eye) {
    return dot(normal, to_light);  // your turn
}

static float3 direct_light(const Scene *scene, const Surface *surface, const float3 to_eye,
                           RayCounts *counts) {
    float3 sum = (float3)(0.0f);
    for (int i = 0; i < scene->light_count; ++i) {
        const Light light = scene->lights[i];
        const Illumination illumination = light_at(light, surface->position);
        if (dot(surface->normal, illumination.direction) > 0.0f) {
            ++counts->shadow;
            if (!in_shadow(scene, light, offset_ray_origin(surface, illumination.direction))) {
                sum += rough(surface->normal, illumination.direction, to_eye)
                       * illumination.irradiance;
            }
        }
    }
    return sum;
}
// #endregion direct_light

// stages/02_shading_shadows/kernel.cl
// #region shade_hit
        const float3 reflectance = scene.materials[surface.material].color.xyz;
        color = reflectance * direct_light(&scene, &surface, -ray.direction, &counts);
// #endregion shade_hit
