// SPDX-License-Identifier: MIT
// Introduced by stage 03; extended by 04 (dielectrics) and 06 (textures): Whitted's ray tracing
// (An Improved Illumination Model for Shaded Display, 1980), as a loop.
#include "closest_hit.cl"
#include "diffuse.cl"
#include "reflection.cl"
#if HAS_DIELECTRIC
#include "dielectric.cl"
#endif
#if HAS_TEXTURES
#include "texture.cl"
#endif

// #region shares
// How a material divides the light it sends on: what comes straight from the lights, and
// what it reflects.
static float diffuse_share(const Material *material) {
    switch (material->type) {
    case MATERIAL_DIFFUSE:
        return 1.0f;
    case MATERIAL_GLOSSY:
        return 1.0f - material->as.glossy.specularity;
    default:
        return 0.0f;
    }
}

static float reflected_share(const Material *material) {
    switch (material->type) {
    case MATERIAL_MIRROR:
        return 1.0f;
    case MATERIAL_GLOSSY:
        return material->as.glossy.specularity;
    default:
        return 0.0f;
    }
}
// #endregion shares

// #region shade
// The light of one hit that needs no further ray; the rays for the rest go onto the stack.
static float3 shade(const Scene *scene, const PendingRay *incoming, const Hit hit, RayStack *stack,
                    RayCounts *counts TEXTURE_PARAMETER) {
    const Surface surface = surface_at(scene, incoming->ray, hit);
    const Material material = scene->materials[surface.material];
    float3 light = (float3)(0.0f);
    float3 weight = incoming->weight * material.color.xyz;
#if HAS_TEXTURES
    weight *= texture_color(&material, surface.texture_coordinates TEXTURE_ARGUMENT);
#endif
#if HAS_DIELECTRIC
    weight *= transmittance(incoming->absorption, hit.distance);
    if (material.type == MATERIAL_DIELECTRIC) {
        const DielectricMaterial glass = material.as.dielectric;
#if METHOD_INTERIOR_PAPER && SPHERE_COUNT > 0
        if (hit.shape == SHAPE_SPHERE) {
            const float3 center = scene->spheres[hit.index].center.xyz;
            spawn_through_sphere(stack, incoming, &surface, &glass, center, weight, counts);
            return light;
        }
#endif
        spawn_dielectric(stack, incoming, &surface, &glass, weight, counts);
    }
#endif
#if HAS_DIFFUSE
    const float diffuse = diffuse_share(&material);
    if (diffuse > 0.0f) {
        light = diffuse * weight * direct_light(scene, &surface, counts);
    }
#endif
#if HAS_REFLECTION
    const float reflected = reflected_share(&material);
    if (reflected > 0.0f) {
        spawn_reflected(stack, incoming, &surface, reflected * weight, counts);
    }
#endif
    return light;
}
// #endregion shade

// #region trace
static float3 trace(const Scene *scene, const Ray primary, RayCounts *counts TEXTURE_PARAMETER) {
    RayStack stack;
    start_stack(&stack, primary);
    float3 color = (float3)(0.0f);
    while (stack.count > 0) {
        const PendingRay incoming = stack.rays[--stack.count];
        const Hit hit = closest_hit(scene, incoming.ray);
        if (hit.shape == SHAPE_NONE) {
            color += incoming.weight * scene->background.xyz;
        } else {
            color += shade(scene, &incoming, hit, &stack, counts TEXTURE_ARGUMENT);
        }
    }
    return color;
}
// #endregion trace
