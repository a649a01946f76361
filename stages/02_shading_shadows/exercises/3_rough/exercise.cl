// SPDX-License-Identifier: MIT
// #stub
// Exercise 02.3: rough instead of ideally diffuse surfaces.
// #solution
// Exercise 02.3, solved: facets that obey Lambert, and shadow and hide each other.
// #end

// kernels/diffuse.cl
// #region direct_light
#define SIGMA 0.6f

// #stub
// Instead of Lambert's cosine.
static float rough(const float3 normal, const float3 to_light, const float3 to_eye) {
    return dot(normal, to_light);  // your turn
}
// #solution
// Instead of Lambert's cosine (Oren and Nayar, Generalization of Lambert's Reflectance Model, SIGGRAPH 1994, the
// qualitative model). What is left of both ways in the surface has the product of the sines and of the cosine
// between them; by the larger cosine, that is the smaller angle's, one sine becomes its tangent.
static float rough(const float3 normal, const float3 to_light, const float3 to_eye) {
    const float square = SIGMA * SIGMA;
    const float a = 1.0f - 0.5f * square / (square + 0.33f);
    const float b = 0.45f * square / (square + 0.09f);
    const float light_cosine = dot(normal, to_light);
    const float eye_cosine = dot(normal, to_eye);
    const float in_surface =
        dot(to_light - light_cosine * normal, to_eye - eye_cosine * normal);
    return light_cosine * (a + b * max(0.0f, in_surface) / max(light_cosine, eye_cosine));
}
// #end

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
