// SPDX-License-Identifier: MIT
// Introduced by stage 09: the light that WIDTH surfaces get straight from the lights.
#include "light.cl"
#include "wide_surface.cl"

#if LIGHT_COUNT > 0
// #region wide_light_at
typedef struct WideIllumination {
    Wide3 direction;  // towards the light, unit length
    Wide share;       // of the light's colour, on a surface that faces it
} WideIllumination;

#if HAS_POINT_LIGHT
// As point_light_at.
static WideIllumination wide_point_light_at(const PointLight light, const Wide3 position) {
    const Wide3 to_light = wide_difference(wide3(light.position.xyz), position);
    const Wide distance_squared = wide_dot(to_light, to_light);
    const Wide distance = sqrt(distance_squared);
    const Wide share = distance / light.range;
    const Wide window = larger(1.0f - share * share * share * share, (Wide)(0.0f));
    const WideIllumination illumination = {wide_scaled(1.0f / distance, to_light),
                                           window * window / distance_squared};
    return illumination;
}
#endif

#if HAS_DIRECTIONAL_LIGHT
static WideIllumination wide_directional_light_at(const DirectionalLight light) {
    const WideIllumination illumination = {wide3(-light.direction.xyz), 1.0f};
    return illumination;
}
#endif

static WideIllumination wide_light_at(const Light light, const Wide3 position) {
#if HAS_POINT_LIGHT && HAS_DIRECTIONAL_LIGHT
    return is_point(light) ? wide_point_light_at(light.as.point, position)
                           : wide_directional_light_at(light.as.directional);
#elif HAS_POINT_LIGHT
    return wide_point_light_at(light.as.point, position);
#else
    return wide_directional_light_at(light.as.directional);
#endif
}
// #endregion wide_light_at

// #region wide_direct_light
// As origin_off.
static Wide3 wide_origin_off(const WideSurfaces *surfaces, const Wide3 direction) {
    const WideInt beneath = wide_dot(surfaces->geometric_normal, direction) < 0.0f;
    return wide_sum(surfaces->position, wide_scaled(beneath ? -surfaces->offset : surfaces->offset,
                                                    surfaces->geometric_normal));
}

// The surfaces in the mask that the light reaches. A line to a point light is a ray that ends after one
// length of its direction.
static WideInt reached_by(const Light light, const Scene *scene, const WideSurfaces *surfaces,
                          const Wide3 direction, const WideInt mask) {
    WideRays rays;
    rays.origin = wide_origin_off(surfaces, direction);
    rays.direction = direction;
    rays.limit = mask ? (Wide)(INFINITY) : (Wide)(-1.0f);
#if HAS_POINT_LIGHT
    if (is_point(light)) {
        rays.direction = wide_difference(wide3(light.as.point.position.xyz), rays.origin);
        rays.limit = mask ? (Wide)(1.0f) : (Wide)(-1.0f);
    }
#endif
    block_hits(scene, &rays, is_point(light));
    return rays.limit > 0.0f;
}

// As direct_light, of the surfaces in the mask. Adds to each lane's number of shadow rays.
static Wide3 wide_direct_light(const Scene *scene, const WideSurfaces *surfaces, const WideInt mask,
                               WideInt *shadow_rays) {
    Wide3 sum = wide3((float3)(0.0f));
    for (int i = 0; i < LIGHT_COUNT; ++i) {
        const Light light = scene->lights[i];
        const WideIllumination illumination = wide_light_at(light, surfaces->position);
        const Wide cosine = wide_dot(surfaces->normal, illumination.direction);
        const WideInt faces = mask & (cosine > 0.0f);
        if (any_lane(faces)) {
            *shadow_rays += faces ? (WideInt)(1) : (WideInt)(0);
            const WideInt reached =
                reached_by(light, scene, surfaces, illumination.direction, faces);
            const Wide share = reached ? cosine * illumination.share : (Wide)(0.0f);
            sum = wide_sum(sum, wide_scaled(share, wide3(light.color.xyz)));
        }
    }
    return sum;
}
// #endregion wide_direct_light
#endif
