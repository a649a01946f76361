// SPDX-License-Identifier: MIT
// Introduced by stage 09: Whitted's ray tracing of WIDTH pixels at a time. Their rays go through the
// scene side by side; what the material of each does is the lesson of the stages before.
#include "shade.cl"
#include "wide_light.cl"

// #region wide_hits
typedef struct HitLanes {
    float distance[WIDTH];
    int shape[WIDTH], index[WIDTH];
#if TRIANGLE_COUNT > 0
    float barycentric_b[WIDTH], barycentric_c[WIDTH];
#endif
} HitLanes;

static void store_hits(HitLanes *lanes, const WideHits *hits) {
    STORE_WIDE(hits->distance, lanes->distance);
    STORE_WIDE(hits->shape, lanes->shape);
    STORE_WIDE(hits->index, lanes->index);
#if TRIANGLE_COUNT > 0
    STORE_WIDE(hits->barycentric_b, lanes->barycentric_b);
    STORE_WIDE(hits->barycentric_c, lanes->barycentric_c);
#endif
}

static Hit get_hit(const HitLanes *lanes, const int lane) {
    Hit hit;
    hit.distance = lanes->distance[lane];
    hit.shape = lanes->shape[lane];
    hit.index = lanes->index[lane];
#if TRIANGLE_COUNT > 0
    hit.barycentric = (float2)(lanes->barycentric_b[lane], lanes->barycentric_c[lane]);
#endif
    return hit;
}
// #endregion wide_hits

// #region wide_shade
// One ray of each lane: the light that its hit sends on at once. The rays for the rest go onto the
// lane's stack.
static Wide3 trace_rays(const Scene *scene, const WideRays *rays, const PendingRay *incoming,
                        RayStack *stacks, RayCounts *counts,
                        WideInt *shadow_rays TEXTURE_PARAMETER) {
    const WideHits hits = closest_hits(scene, rays);
    HitLanes hit_lanes;
    store_hits(&hit_lanes, &hits);
    SurfaceLanes surface_lanes;
    for (int lane = 0; lane < WIDTH; ++lane) {
        const Hit hit = get_hit(&hit_lanes, lane);
        if (hit.shape != SHAPE_NONE) {
            const Surface fetched = fetch_surface(scene, incoming[lane].ray, hit);
            put_surface(&surface_lanes, lane, &fetched);
        }
    }
    const WideSurfaces surfaces = finish_surfaces(rays, hits.distance, &surface_lanes);
    store_surfaces(&surface_lanes, &surfaces);
    Lanes3 weights;
    int lit[WIDTH];
    for (int lane = 0; lane < WIDTH; ++lane) {
        const Hit hit = get_hit(&hit_lanes, lane);
        float3 weight = incoming[lane].weight * scene->background.xyz;
        lit[lane] = 0;
        if (hit.shape != SHAPE_NONE) {
            const Surface surface = get_surface(&surface_lanes, lane);
            lit[lane] = shade(scene, &incoming[lane], hit, &surface, &weight, &stacks[lane],
                              &counts[lane] TEXTURE_ARGUMENT);
        }
        put_lane(&weights, lane, weight);
    }
    const WideInt missed = hits.distance == INFINITY;
    Wide3 light = wide3((float3)(0.0f));
#if LIGHT_COUNT > 0
    light = wide_direct_light(scene, &surfaces, LOAD_WIDE(lit) != 0, shadow_rays);
#endif
    light.x = missed ? (Wide)(1.0f) : light.x;
    light.y = missed ? (Wide)(1.0f) : light.y;
    light.z = missed ? (Wide)(1.0f) : light.z;
    return wide_product(load_lanes(&weights), light);
}
// #endregion wide_shade

// #region wide_trace
#if HAS_REFLECTION || HAS_DIELECTRIC
// The next ray of each lane's stack. False when none has one.
static bool pop_rays(RayStack *stacks, PendingRay *incoming, WideRays *rays) {
    Lanes3 origins, directions;
    float limits[WIDTH];
    bool any = false;
    for (int lane = 0; lane < WIDTH; ++lane) {
        limits[lane] = -1.0f;
        put_lane(&origins, lane, (float3)(0.0f));
        put_lane(&directions, lane, (float3)(1.0f));
        if (stacks[lane].count > 0) {
            copy_pending(&incoming[lane], &stacks[lane].rays[--stacks[lane].count]);
            limits[lane] = INFINITY;
            put_lane(&origins, lane, incoming[lane].ray.origin);
            put_lane(&directions, lane, incoming[lane].ray.direction);
            any = true;
        }
    }
    rays->origin = load_lanes(&origins);
    rays->direction = load_lanes(&directions);
    rays->limit = LOAD_WIDE(limits);
    return any;
}
#endif

// As trace, of a tile's primary rays; `sum` comes empty.
static Wide3 trace_tile(const Scene *scene, WideRays rays, RayCounts *sum TEXTURE_PARAMETER) {
    PendingRay incoming[WIDTH];
    RayStack stacks[WIDTH];
    RayCounts counts[WIDTH];
    WideInt shadow_rays = 0;
    Lanes3 origins, directions;
    store_lanes(&origins, rays.origin);
    store_lanes(&directions, rays.direction);
    for (int lane = 0; lane < WIDTH; ++lane) {
        const Ray ray = {get_lane(&origins, lane), get_lane(&directions, lane)};
        const PendingRay primary = primary_ray(ray);
        copy_pending(&incoming[lane], &primary);
        stacks[lane].count = 0;
        counts[lane] = *sum;
    }
    Wide3 color =
        trace_rays(scene, &rays, incoming, stacks, counts, &shadow_rays TEXTURE_ARGUMENT);
#if HAS_REFLECTION || HAS_DIELECTRIC
    while (pop_rays(stacks, incoming, &rays)) {
        color = wide_sum(color, trace_rays(scene, &rays, incoming, stacks, counts,
                                           &shadow_rays TEXTURE_ARGUMENT));
    }
#endif
    sum->shadow = sum_of_lanes(shadow_rays);
    for (int lane = 0; lane < WIDTH; ++lane) {
        sum->reflection += counts[lane].reflection;
        sum->refraction += counts[lane].refraction;
        sum->dropped += counts[lane].dropped;
        sum->faded += counts[lane].faded;
        sum->faded_weight = max(sum->faded_weight, counts[lane].faded_weight);
    }
    return color;
}
// #endregion wide_trace
