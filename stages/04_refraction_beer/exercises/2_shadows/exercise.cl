// SPDX-License-Identifier: MIT
// #stub
// Exercise 04.2: what is left of the light on its way to a surface.
// #solution
// Exercise 04.2, solved: Beer's law along the straight way, for each sphere of glass.
// #end

// kernels/diffuse.cl
// #region direct_light
// #stub
// The share of the light that comes along a shadow ray, which ends after the distance `end`.
static float3 light_through(const Scene *scene, const Ray ray, const float end) {
    return closest_hit(scene, ray).distance < end ? (float3)(0.0f) : (float3)(1.0f);  // your turn
}
// #solution
// How much of a ray's way, from its origin to the distance `end`, lies within a sphere: see intersect_ray_sphere.
static float way_within(const Ray ray, const float end, const Sphere sphere) {
    const float3 to_center = XYZ(sphere.center) - ray.origin;
    const float nearest = dot(to_center, ray.direction);
    const float3 perpendicular = to_center - nearest * ray.direction;
    const float half_chord_squared = sphere.radius * sphere.radius - dot(perpendicular, perpendicular);
    const float half_chord = sqrt(max(half_chord_squared, 0.0f));
    return max(min(nearest + half_chord, end) - max(nearest - half_chord, 0.0f), 0.0f);
}

// The share of the light that comes along a shadow ray, which ends after the distance `end`.
static float3 light_through(const Scene *scene, const Ray ray, const float end) {
    float3 share = (float3)(1.0f);
    for (int i = 0; i < scene->sphere_count; ++i) {
        const Sphere sphere = scene->spheres[i];
        const Material material = scene->materials[sphere.material];
        const float within = way_within(ray, end, sphere);
        if (material.type == MATERIAL_DIELECTRIC) {
            share *= exp(-XYZ(material.as.dielectric.absorption) * within);
        } else if (within > 0.0f && within < end) {  // not with both ends in it
            return (float3)(0.0f);
        }
    }
    for (int i = 0; i < scene->plane_count; ++i) {
        const Plane plane = scene->planes[i];
        if (intersect_ray_plane(ray, XYZ(plane.normal), plane.offset) < end) {
            return (float3)(0.0f);
        }
    }
    return share;
}
// #end

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
