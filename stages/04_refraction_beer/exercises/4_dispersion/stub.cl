// SPDX-License-Identifier: MIT
// Exercise 04.4: the stack, and what an interface puts onto it.

// kernels/ray_stack.cl
// #region stack
typedef struct RayStack {
    int count;
    PendingRay rays[STACK_SIZE];  // your turn
} RayStack;
// #endregion stack

// kernels/dielectric.cl
// #region spawn_dielectric
#define DISPERSION 0.05f

static void spawn_dielectric(RayStack *stack, const PendingRay *incoming, const Surface *surface,
                             const DielectricMaterial *glass, const float3 weight,
                             RayCounts *counts) {
    PendingRay here = *incoming;
    if (surface->from_behind) {  // what is reflected in glass runs in it, even if the eye was there
        here.absorption = XYZ(glass->absorption);
    }
    // your turn
    const Interface interface = interface_at(surface, incoming->ray.direction, glass->ior);
    spawn_reflected(stack, &here, surface, weight * interface.reflectance, counts);
    if (interface.reflectance < 1.0f) {
        PendingRay refracted;
        refracted.ray.origin = offset_ray_origin(surface, -surface->geometric_normal);
        refracted.ray.direction = interface.refracted;
        refracted.weight = weight * (1.0f - interface.reflectance);
        refracted.depth = incoming->depth + 1;
        refracted.absorption = surface->from_behind ? (float3)(0.0f) : XYZ(glass->absorption);
        push_ray(stack, refracted, &counts->refraction, counts);
    }
}
// #endregion spawn_dielectric
