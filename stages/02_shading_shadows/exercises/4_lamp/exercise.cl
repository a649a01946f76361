// SPDX-License-Identifier: MIT
// #stub
// Exercise 02.4: lamps that have a size, and the soft shadows that they cast.
// #solution
// Exercise 02.4, solved: a shadow line to each of the points of a sunflower on the lamp.
// #end

// kernels/diffuse.cl
// #region direct_light
#define LAMP_RADIUS 0.7f
#define LAMP_POINTS 64
// #stub
// #solution
#define GOLDEN_ANGLE 2.3999632f  // radians
// #end

// #stub
// The share of the light, which lies in a direction of unit length, that is seen from `origin`.
static float lit_share(const Scene *scene, const Light light, const float3 origin,
                       const float3 direction, RayCounts *counts) {
    ++counts->shadow;  // your turn
    return in_shadow(scene, light, origin) ? 0.0f : 1.0f;
}
// #solution
// The share of the light, which lies in a direction of unit length, that is seen from `origin`. The points of a disk
// at right angles to it are those of Vogel (A Better Way to Construct the Sunflower Head, Mathematical Biosciences
// 44, 1979).
static float lit_share(const Scene *scene, const Light light, const float3 origin,
                       const float3 direction, RayCounts *counts) {
    if (is_point(light)) {
        const float3 size = fabs(direction);
        const float3 aside = size.x <= min(size.y, size.z) ? (float3)(1.0f, 0.0f, 0.0f)
                             : size.y <= size.z            ? (float3)(0.0f, 1.0f, 0.0f)
                                                           : (float3)(0.0f, 0.0f, 1.0f);
        const float3 right = normalize(cross(direction, aside));
        const float3 up = cross(right, direction);
        int seen = 0;
        for (int i = 0; i < LAMP_POINTS; ++i) {
            const float radius = LAMP_RADIUS * sqrt((i + 0.5f) / LAMP_POINTS);
            const float angle = i * GOLDEN_ANGLE;
            const Line line = {origin, light.as.point.position.xyz
                                           + radius * (cos(angle) * right + sin(angle) * up)};
            seen += any_hit_line(scene, line) ? 0 : 1;
        }
        counts->shadow += LAMP_POINTS;
        return (float)seen / LAMP_POINTS;
    }
    ++counts->shadow;
    return in_shadow(scene, light, origin) ? 0.0f : 1.0f;
}
// #end

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
