// SPDX-License-Identifier: MIT
// Introduced by stage 03; extended by 04 (dielectrics) and 06 (textures, colours of vertices): what a material
// does with the light of a ray that met it.
#include "reflection.cl"
#include "surface.cl"
#include "dielectric.cl"
#include "texture.cl"

// #region shares
// Of the light that a material sends on, the share that it reflects. What it does not comes straight from the
// lights.
static float reflected_share(const Material *material) {
    if (material->type == MATERIAL_GLOSSY) {
        return material->as.glossy.specularity;
    }
    return material->type == MATERIAL_MIRROR ? 1.0f : 0.0f;
}
// #endregion shares

// #region shade
// Whether the surface sends on light that comes straight from the lights, and the weight of that in
// the pixel; the rays for what else it sends on go onto the stack.
static bool shade(const Scene *scene, const PendingRay *incoming, const Hit hit, const Surface *surface,
                  float3 *direct_weight, RayStack *stack, RayCounts *counts, TEXTURES textures) {
    const Material material = scene->materials[surface->material];
    // #region surface_color
    float3 weight = incoming->weight * XYZ(material.color);
    if (HAS_TEXTURES) {
        weight *= texture_color(&material, surface->texture_coordinates, textures);
    }
    if (HAS_VERTEX_COLORS && hit.shape == SHAPE_TRIANGLE) {
        weight *= vertex_color(scene, hit);
    }
    // #endregion surface_color
    // #region shade_dielectric
    if (HAS_DIELECTRIC) {
        weight *= transmittance(incoming->absorption, hit.distance);
    }
    if (HAS_DIELECTRIC && material.type == MATERIAL_DIELECTRIC) {
        const DielectricMaterial glass = material.as.dielectric;
        if (HAS_MEDIA && is_overruled(&glass, incoming->media)) {
            pass_through(stack, incoming, hit.distance, surface, &glass, counts);
            return false;
        }
        if (METHOD_INTERIOR_PAPER && hit.shape == SHAPE_SPHERE) {
            const float3 center = XYZ(scene->spheres[hit.index].center);
            spawn_through_sphere(stack, incoming, surface, &glass, center, weight, counts);
            return false;
        }
        spawn_dielectric(scene, stack, incoming, surface, &glass, weight, counts);
        return false;
    }
    // #endregion shade_dielectric
    // #region shade_shares
    const float reflected = reflected_share(&material);
    if (HAS_REFLECTION && reflected > 0.0f) {
        spawn_reflected(stack, incoming, surface, reflected * weight, counts);
    }
    *direct_weight = (1.0f - reflected) * weight;
    return reflected < 1.0f;
    // #endregion shade_shares
}
// #endregion shade
