// SPDX-License-Identifier: MIT
// #stub
// Exercise 04.4: the stack, and what an interface puts onto it.
// #solution
// Exercise 04.4, solved: three indices, three refracted rays, each of one channel.
// #end

// kernels/ray_stack.cl
// #region stack
// #stub
typedef struct RayStack {
    int count;
    PendingRay rays[STACK_SIZE];  // your turn
} RayStack;
// #solution
// The first interface leaves four rays where there were two before; those that it refracted have one channel each
// and split in two. What it reflected lies beneath them, and splits in four only when they are all gone.
typedef struct RayStack {
    int count;
    PendingRay rays[STACK_SIZE + 2];
} RayStack;
// #end
// #endregion stack

// kernels/dielectric.cl
// #region spawn_dielectric
#define DISPERSION 0.05f

static void spawn_dielectric(const Scene *scene, RayStack *stack, const PendingRay *incoming,
                             const Surface *surface, const DielectricMaterial *glass, const float3 weight,
                             RayCounts *counts) {
    const DielectricMaterial outside = medium_at(scene, incoming->media & ~glass->medium);
// #stub
    // your turn
    const Interface interface = interface_at(surface, incoming->ray.direction, glass->ior / outside.ior);
    spawn_reflected(stack, incoming, surface, weight * interface.reflectance, counts);
    if (interface.reflectance < 1.0f) {
        PendingRay refracted;
        refracted.ray.origin = offset_ray_origin(surface, -surface->geometric_normal);
        refracted.ray.direction = interface.refracted;
        refracted.weight = weight * (1.0f - interface.reflectance);
        refracted.depth = incoming->depth + 1;
        refracted.media = media_beyond(incoming->media, surface, glass);
        refracted.absorption = surface->from_behind ? XYZ(outside.absorption) : XYZ(glass->absorption);
        push_ray(stack, refracted, &counts->refraction, counts);
    }
// #solution
    Interface interfaces[3];
    for (int channel = 0; channel < 3; ++channel) {
        const float ior = glass->ior + DISPERSION * (float)(channel - 1);
        interfaces[channel] = interface_at(surface, incoming->ray.direction, ior / outside.ior);
    }
    const float3 reflectance = (float3)(interfaces[0].reflectance, interfaces[1].reflectance,
                                        interfaces[2].reflectance);
    spawn_reflected(stack, incoming, surface, weight * reflectance, counts);
    for (int channel = 0; channel < 3; ++channel) {
        const float3 only = (float3)(channel == 0, channel == 1, channel == 2);
        PendingRay refracted;
        refracted.weight = only * weight * (1.0f - reflectance);
        if (dot(refracted.weight, only) > 0.0f) {  // neither another channel's ray nor totally reflected
            refracted.ray.origin = offset_ray_origin(surface, -surface->geometric_normal);
            refracted.ray.direction = interfaces[channel].refracted;
            refracted.depth = incoming->depth + 1;
            refracted.media = media_beyond(incoming->media, surface, glass);
            refracted.absorption = surface->from_behind ? XYZ(outside.absorption) : XYZ(glass->absorption);
            push_ray(stack, refracted, &counts->refraction, counts);
        }
    }
// #end
}
// #endregion spawn_dielectric
