// SPDX-License-Identifier: MIT
// Introduced by stage 03: mirrors. The direction in which a surface sees, and the ray for it.
#include "origin.cl"
#include "ray_stack.cl"

// #region reflect
// #region law_of_reflection
// The law of reflection; `normal` may be on either side of the surface.
static float3 reflect(const float3 direction, const float3 normal) {
    return direction - 2.0f * dot(direction, normal) * normal;
}
// #endregion law_of_reflection

// #region reflected_ray
// On a smooth mesh the shading normal may lean so far that the reflected ray would dive
// beneath the facet: it is folded back up, without a step where that begins.
static Ray reflected_ray(const Surface *surface, const float3 direction) {
    float3 reflected = reflect(direction, surface->normal);
    if (dot(reflected, surface->geometric_normal) < 0.0f) {
        reflected = reflect(reflected, surface->geometric_normal);
    }
    const Ray ray = {offset_ray_origin(surface, surface->geometric_normal), normalize(reflected)};
    return ray;
}
// #endregion reflected_ray
// #endregion reflect

// #region spawn_reflected
static void spawn_reflected(RayStack *stack, const PendingRay *incoming, const Surface *surface,
                            const float3 weight, RayCounts *counts) {
    PendingRay reflected = *incoming;  // a reflection stays in its medium
    reflected.ray = reflected_ray(surface, incoming->ray.direction);
    reflected.weight = weight;
    ++reflected.depth;
    push_ray(stack, reflected, &counts->reflection, counts);
}
// #endregion spawn_reflected
