// SPDX-License-Identifier: MIT
// Introduced by stage 10: what is there where WIDTH rays have hit. What lies in memory is fetched
// lane by lane; what is arithmetic is done for all lanes at once.
#include "packets/normalise/exact.cl"
#include "surface.cl"
#include "packets/hit.cl"
#include "packets/origin.cl"

// #region surface_lanes
// Which each lane's Surface can be taken from.
typedef struct SurfaceLanes {
    Lanes3 position, normal, geometric_normal;
    LanesInt from_behind;
    Lanes ray_offset;
    int material[WIDTH];
    float2 texture_coordinates[WIDTH];
} SurfaceLanes;
// #endregion surface_lanes

// #region put_surface
// As it was fetched: the rest is worked out for all lanes.
static void put_surface(SurfaceLanes *lanes, const int lane, const Surface *surface) {
    put_lane(&lanes->position, lane, surface->position);
    put_lane(&lanes->normal, lane, surface->normal);
    put_lane(&lanes->geometric_normal, lane, surface->geometric_normal);
    lanes->ray_offset.lane[lane] = surface->ray_offset;
    lanes->material[lane] = surface->material;
    lanes->texture_coordinates[lane] = surface->texture_coordinates;
}
// #endregion put_surface

// #region finish
// As finish_triangle, and the end of surface_at.
static WideSurfaces finish_surfaces(const WideRays *rays, const SurfaceLanes *lanes) {
    WideSurfaces surfaces;
    surfaces.position = load_lanes(&lanes->position);
    surfaces.normal = wide_normalize(load_lanes(&lanes->normal));
    surfaces.geometric_normal = wide_normalize(load_lanes(&lanes->geometric_normal));
    const WideInt inward = wide_dot(surfaces.geometric_normal, surfaces.normal) < 0.0f;
    surfaces.geometric_normal = turned(inward, surfaces.geometric_normal);
    surfaces.from_behind = wide_dot(surfaces.geometric_normal, rays->direction) > 0.0f;
    surfaces.normal = turned(surfaces.from_behind, surfaces.normal);
    surfaces.geometric_normal = turned(surfaces.from_behind, surfaces.geometric_normal);
    surfaces.ray_offset = wide_ray_offset(rays, lanes->ray_offset.wide);
    return surfaces;
}

static void store_surfaces(SurfaceLanes *lanes, const WideSurfaces *surfaces) {
    store_lanes(&lanes->position, surfaces->position);
    store_lanes(&lanes->normal, surfaces->normal);
    store_lanes(&lanes->geometric_normal, surfaces->geometric_normal);
    lanes->from_behind.wide = surfaces->from_behind;
    lanes->ray_offset.wide = surfaces->ray_offset;
}

static Surface get_surface(const SurfaceLanes *lanes, const int lane) {
    Surface surface;
    surface.position = get_lane(&lanes->position, lane);
    surface.normal = get_lane(&lanes->normal, lane);
    surface.geometric_normal = get_lane(&lanes->geometric_normal, lane);
    surface.from_behind = lanes->from_behind.lane[lane] != 0;
    surface.material = lanes->material[lane];
    surface.ray_offset = lanes->ray_offset.lane[lane];
    surface.texture_coordinates = lanes->texture_coordinates[lane];
    return surface;
}
// #endregion finish
