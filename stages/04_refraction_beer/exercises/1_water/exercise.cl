// SPDX-License-Identifier: MIT
// #stub
// Exercise 04.1: where a dielectric meets what surrounds it, which is air.
// #solution
// Exercise 04.1, solved: in Snell's law and in Fresnel's, indices come in as their ratio alone.
// #end

// kernels/dielectric.cl
// #region interface
#define OUTSIDE 1.33f

// What a ray meets at the surface of a dielectric: the share that is reflected and, unless
// that is all, the direction of the rest.
typedef struct Interface {
    float reflectance;
    float3 refracted;
} Interface;

static Interface interface_at(const Surface *surface, const float3 direction, const float ior) {
    Interface interface;
// #stub
    const float ratio = surface->from_behind ? ior : 1.0f / ior;  // your turn
// #solution
    const float relative = ior / OUTSIDE;
    const float ratio = surface->from_behind ? relative : 1.0f / relative;
// #end
    if (!refract(direction, surface->normal, ratio, &interface.refracted)) {
        interface.reflectance = 1.0f;
        return interface;
    }
    const float3 thinner_side = ratio > 1.0f ? interface.refracted : direction;
    const float cosine = fabs(dot(thinner_side, surface->normal));
// #stub
    interface.reflectance = fresnel(cosine, ior);
// #solution
    interface.reflectance = fresnel(cosine, relative);
// #end
    return interface;
}
// #endregion interface
