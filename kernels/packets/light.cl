// SPDX-License-Identifier: MIT
// Introduced by stage 10; extended by 11 (smooth meshes): the light that WIDTH surfaces get straight from the
// lights.
#include "light.cl"
#include "packets/surface.cl"
#include "packets/terminator/hanika.cl"

// #region wide_light_at
typedef struct WideIllumination {
    Wide3 direction;  // towards the light, unit length
    Wide share;       // of the light's colour, on a surface that faces it
} WideIllumination;

// As point_light_at.
static WideIllumination wide_point_light_at(const PointLight light, const Wide3 position) {
    const Wide3 to_light = wide_difference(wide3(XYZ(light.position)), position);
    const Wide distance_squared = wide_dot(to_light, to_light);
    const Wide distance = sqrt(distance_squared);
    const Wide share = distance / light.range;
    const Wide window = MAX(1.0f - share * share * share * share, (Wide)(0.0f));
    const WideIllumination illumination = {wide_scaled(1.0f / distance, to_light),
                                           window * window / distance_squared};
    return illumination;
}

static WideIllumination wide_directional_light_at(const DirectionalLight light) {
    const WideIllumination illumination = {wide3(-XYZ(light.direction)), 1.0f};
    return illumination;
}

static WideIllumination wide_light_at(const Light light, const Wide3 position) {
    return is_point(light) ? wide_point_light_at(light.as.point, position)
                           : wide_directional_light_at(light.as.directional);
}
// #endregion wide_light_at

// #region wide_direct_light
// From the surfaces in the mask. A line to a point light is a ray that ends after one length of its
// direction.
static WideRays shadow_rays_to(const Light light, const WideSurfaces *surfaces, const Wide3 direction,
                               const WideInt mask) {
    WideRays rays;
    rays.origin = wide_offset_ray_origin(surfaces, direction);
    rays.direction = direction;
    rays.t_max = mask ? (Wide)(INFINITY) : (Wide)(-1.0f);
    if (is_point(light)) {
        rays.direction = wide_difference(wide3(XYZ(light.as.point.position)), rays.origin);
        rays.t_max = mask ? (Wide)(1.0f) : (Wide)(-1.0f);
    }
    return rays;
}

// As direct_light, of the surfaces of all packets where they are `lit`: adds the light to the colours,
// by its weight, and its rays to each lane's number of them.
static void add_direct_light(const Scene *scene, const WideSurfaces *surfaces, const WideInt *lit,
                             const Wide3 *weights, Wide3 *colors, WideInt *shadow_rays) {
    for (int i = 0; i < scene->light_count; ++i) {
        const Light light = scene->lights[i];
        WideRays rays[PACKETS];
        Wide shares[PACKETS];
        WideInt any = 0;
        for (int packet = 0; packet < PACKETS; ++packet) {
            if (!any_lane(lit[packet])) {
                rays[packet] = no_rays();
                continue;
            }
            const WideSurfaces *surface = &surfaces[packet];
            const WideIllumination illumination = wide_light_at(light, surface->position);
            Wide cosine = wide_dot(surface->normal, illumination.direction);
            if (HAS_SMOOTH_MESH) {
                cosine *= wide_shadowing(surface, illumination.direction, cosine);
            }
            const WideInt faces = lit[packet] & (cosine > 0.0f);
            shares[packet] = cosine * illumination.share;
            rays[packet] = shadow_rays_to(light, surface, illumination.direction, faces);
            *shadow_rays += faces ? (WideInt)(1) : (WideInt)(0);
            any |= faces;
        }
        if (any_lane(any)) {
            block_hits(scene, rays, is_point(light));
            for (int packet = 0; packet < PACKETS; ++packet) {
                const Wide3 reflected =
                    wide_product(weights[packet], wide_scaled(shares[packet], wide3(XYZ(light.color))));
                colors[packet] = wide_sum(colors[packet], masked(rays[packet].t_max > 0.0f, reflected));
            }
        }
    }
}
// #endregion wide_direct_light
