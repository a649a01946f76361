// SPDX-License-Identifier: MIT
// Exercise 04.2: what is left of the light on its way to a surface.

// kernels/diffuse.cl
// #region direct_light
// The share of the light that comes along a shadow ray, which ends after the distance `end`.
static float3 light_through(const Scene *scene, const Ray ray, const float end) {
    return closest_hit(scene, ray).distance < end ? (float3)(0.0f) : (float3)(1.0f);  // your turn
}

static float3 direct_light(const Scene *scene, const Surface *surface, RayCounts *counts) {
    float3 sum = (float3)(0.0f);
    for (int i = 0; i < scene->light_count; ++i) {
        const Light light = scene->lights[i];
        const Illumination illumination = light_at(light, surface->position);
        const float cosine = dot(surface->normal, illumination.direction);
        if (cosine > 0.0f) {
            ++counts->shadow;
            const Ray ray = {offset_ray_origin(surface, illumination.direction), illumination.direction};
            const float end = is_point(light) ? distance(ray.origin, XYZ(light.as.point.position)) : INFINITY;
            sum += cosine * illumination.irradiance * light_through(scene, ray, end);
        }
    }
    return sum;
}
// #endregion direct_light
