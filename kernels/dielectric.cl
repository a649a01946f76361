// SPDX-License-Identifier: MIT
// Introduced by stage 04; extended by 11 (smooth meshes): glass. What is reflected, what goes through,
// and what is lost inside.
#include "media.cl"
#include "origin.cl"
#include "ray_stack.cl"
#include "reflection.cl"
#include "fresnel/schlick.cl"
#include "transmission/exp.cl"

// #region refract
// Snell's law in vectors; `ratio` is the index of refraction on the side of `normal` over that
// beyond. False where there is no such direction: total internal reflection.
static bool refract(const float3 direction, const float3 normal, const float ratio, float3 *refracted) {
    const float cosine = -dot(direction, normal);
    const float sine_squared = ratio * ratio * (1.0f - cosine * cosine);
    if (sine_squared > 1.0f) {
        return false;
    }
    const float beyond = ratio * cosine - sqrt(1.0f - sine_squared);
    *refracted = normalize(ratio * direction + beyond * normal);
    return true;
}
// #endregion refract

// #region smooth_glass
// On a smooth mesh the shading normal leans away from the facet's. It may even be turned away from the
// ray: beyond grazing, where all is reflected.
static bool is_turned_away(const Surface *surface, const float3 direction) {
    return dot(direction, surface->normal) >= 0.0f;
}

// And what is refracted by it may come out above the facet: it is folded back beneath, as what is
// reflected is folded back up, without a step where that begins.
static float3 folded_below(const Surface *surface, const float3 refracted) {
    return dot(refracted, surface->geometric_normal) > 0.0f ? reflect(refracted, surface->geometric_normal)
                                                            : refracted;
}
// #endregion smooth_glass

// #region interface
// What a ray meets at the surface of a dielectric: the share that is reflected and, unless
// that is all, the direction of the rest.
typedef struct Interface {
    float reflectance;
    float3 refracted;
} Interface;

// #region interface_at
static Interface interface_at(const Surface *surface, const float3 direction, const float ior) {
    Interface interface;
    const float ratio = surface->from_behind ? ior : 1.0f / ior;
    bool is_split = refract(direction, surface->normal, ratio, &interface.refracted);
    if (HAS_DIELECTRIC_MESH && is_turned_away(surface, direction)) {
        is_split = false;
    }
    if (!is_split) {
        interface.reflectance = 1.0f;
        return interface;
    }
    const float3 thinner_side = ratio > 1.0f ? interface.refracted : direction;
    const float cosine = fabs(dot(thinner_side, surface->normal));
    interface.reflectance = fresnel(cosine, ior);
    if (HAS_DIELECTRIC_MESH) {
        interface.refracted = folded_below(surface, interface.refracted);
    }
    return interface;
}
// #endregion interface_at
// #endregion interface

// #region spawn_dielectric
// At every wall, inside as outside, one ray is reflected and one goes through.
static void spawn_dielectric(const Scene *scene, RayStack *stack, const PendingRay *incoming,
                             const Surface *surface, const DielectricMaterial *glass, const float3 weight,
                             RayCounts *counts) {
    const DielectricMaterial outside = medium_at(scene, incoming->media & ~glass->medium);
    // #region at_wall
    const Interface interface = interface_at(surface, incoming->ray.direction, glass->ior / outside.ior);
    // #endregion at_wall
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
}
// #endregion spawn_dielectric

// #region pass_through
// Where another medium is there on both sides, the ray goes on as it was, and no bounce deeper.
static void pass_through(RayStack *stack, const PendingRay *incoming, const float distance, const Surface *surface,
                         const DielectricMaterial *glass, RayCounts *counts) {
    PendingRay on = *incoming;
    on.ray.origin = offset_ray_origin(surface, incoming->ray.direction);
    on.weight *= transmittance(incoming->absorption, distance);
    on.media = media_beyond(incoming->media, surface, glass);
    push_ray(stack, on, &counts->refraction, counts);
}
// #endregion pass_through

// #region interior_paper
// The paper's way (section 5): once through the sphere and out, no reflection inside.
// From a point on a sphere, the point of the ray nearest the centre is half-way to the other wall.
static float intersect_ray_inside_sphere(const Ray ray, const float3 center) {
    return 2.0f * dot(center - ray.origin, ray.direction);
}

static void spawn_through_sphere(RayStack *stack, const PendingRay *incoming, const Surface *surface,
                                 const DielectricMaterial *glass, const float3 center, const float3 weight,
                                 RayCounts *counts) {
    const Interface interface = interface_at(surface, incoming->ray.direction, glass->ior);
    PendingRay leaving = *incoming;
    leaving.weight = weight;
    ++leaving.depth;
    leaving.absorption = (float3)(0.0f);
    leaving.ray.direction = interface.refracted;
    leaving.ray.origin = offset_ray_origin(surface, interface.refracted);
    bool leaves = interface.reflectance < 1.0f;
    if (!surface->from_behind) {
        spawn_reflected(stack, incoming, surface, weight * interface.reflectance, counts);
        const Ray inside = {surface->position, interface.refracted};
        const float chord = intersect_ray_inside_sphere(inside, center);
        const float3 exit = inside.origin + chord * inside.direction;
        const float3 inward = normalize(center - exit);
        leaves = leaves && refract(inside.direction, inward, glass->ior, &leaving.ray.direction);
        leaving.weight *= 1.0f - interface.reflectance;
        leaving.weight *= transmittance(XYZ(glass->absorption), chord);
        leaving.ray.origin = offset_along(exit, -inward, surface->ray_offset);
    }
    if (leaves) {
        push_ray(stack, leaving, &counts->refraction, counts);
    }
}
// #endregion interior_paper
