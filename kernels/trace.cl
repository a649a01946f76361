// SPDX-License-Identifier: MIT
// Introduced by stage 03; extended by 04 (media) and 06 (textures): Whitted's ray tracing (An Improved
// Illumination Model for Shaded Display, 1980), as a loop. The kernel has included closest_hit.
#include "diffuse.cl"
#include "shade.cl"
#include "terminator/hanika.cl"

// #region trace
static float3 trace(const Scene *scene, const Ray primary, RayCounts *counts, TEXTURES textures) {
    RayStack stack;
    stack.rays[0] = primary_ray(primary);
    stack.count = 1;
    if (HAS_MEDIA) {
        stack.rays[0].media = scene->eye_media;
        stack.rays[0].absorption = XYZ(medium_at(scene, scene->eye_media).absorption);
    }
    float3 color = (float3)(0.0f);
    // #region next_ray
    while (stack.count > 0) {
        const PendingRay incoming = pop_ray(&stack);
        const Hit hit = closest_hit(scene, incoming.ray);
        // #endregion next_ray
        if (hit.shape == SHAPE_NONE) {
            // #region miss
            float3 light = XYZ(scene->background);
            if (HAS_MEDIA) {
                light *= transmittance(incoming.absorption, MAXFLOAT);  // of water without a shore, nothing
            }
            // #region add_background
            color += incoming.weight * light;
            // #endregion add_background
            // #endregion miss
        } else {
            // #region hit_surface
            Surface surface = surface_at(scene, incoming.ray, hit);
            // #endregion hit_surface
            float3 weight;
            if (shade(scene, &incoming, hit, &surface, &weight, &stack, counts, textures)) {
                // #region direct
                if (HAS_SMOOTH_MESH && hit.shape == SHAPE_TRIANGLE) {
                    surface.position += lift_off_facet(scene, &surface, hit);
                }
                // #region add_direct
                color += weight * direct_light(scene, &surface, counts);
                // #endregion add_direct
                // #endregion direct
            }
        }
    }
    return color;
}
// #endregion trace
