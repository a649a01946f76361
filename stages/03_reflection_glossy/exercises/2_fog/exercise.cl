// SPDX-License-Identifier: MIT
// #stub
// Exercise 03.2: the loop over the rays of a pixel, to be filled with fog.
// #solution
// Exercise 03.2, solved: what fog takes goes off the ray's weight, and so off all that the ray leads to.
// #end

// kernels/trace.cl
// #region trace
#define FOG_DENSITY 0.07f
#define FOG_COLOR (float3)(0.66f, 0.68f, 0.7f)

static float3 trace(const Scene *scene, const Ray primary, RayCounts *counts, TEXTURES textures) {
    RayStack stack;
    stack.rays[0] = primary_ray(primary);
    stack.count = 1;
    float3 color = (float3)(0.0f);
    while (stack.count > 0) {
// #stub
        const PendingRay incoming = stack.rays[--stack.count];
        const Hit hit = closest_hit(scene, incoming.ray);
        // your turn
// #solution
        PendingRay incoming = stack.rays[--stack.count];
        const Hit hit = closest_hit(scene, incoming.ray);
        const float clear = exp(-FOG_DENSITY * hit.distance);  // 0 where nothing was hit
        color += (1.0f - clear) * incoming.weight * FOG_COLOR;
        incoming.weight *= clear;
// #end
        if (hit.shape == SHAPE_NONE) {
            color += incoming.weight * XYZ(scene->background);
        } else {
            const Surface surface = surface_at(scene, incoming.ray, hit);
            float3 weight;
            if (shade(scene, &incoming, hit, &surface, &weight, &stack, counts, textures)) {
                color += weight * direct_light(scene, &surface, counts);
            }
        }
    }
    return color;
}
// #endregion trace
