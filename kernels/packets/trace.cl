// SPDX-License-Identifier: MIT
// Introduced by stage 10; extended by 11 (smooth meshes): Whitted's ray tracing of all pixels of a work-item.
// Their rays go through the scene together; what the material of each does is the lesson of the stages before.
#include "shade.cl"
#include "terminator/hanika.cl"
#include "packets/light.cl"

// #region wide_hits
typedef struct HitLanes {
    Lanes distance;
    LanesInt shape, index;
    Lanes barycentric_b, barycentric_c;
} HitLanes;

static void store_hits(HitLanes *lanes, const Wide distance, const WideHits *hits) {
    lanes->distance.wide = distance;
    lanes->shape.wide = hits->shape;
    lanes->index.wide = hits->index;
    lanes->barycentric_b.wide = hits->barycentric_b;
    lanes->barycentric_c.wide = hits->barycentric_c;
}

static Hit get_hit(const HitLanes *lanes, const int lane) {
    Hit hit;
    hit.distance = lanes->distance.lane[lane];
    hit.shape = lanes->shape.lane[lane];
    hit.index = lanes->index.lane[lane];
    hit.barycentric = (float2)(lanes->barycentric_b.lane[lane], lanes->barycentric_c.lane[lane]);
    return hit;
}
// #endregion wide_hits

// #region incoming
// The ray that each lane follows, as PendingRay.
typedef struct IncomingLanes {
    Lanes3 origin, direction, weight;
    LanesInt depth;
    LanesInt media;
    Lanes3 absorption;
} IncomingLanes;

// As primary_ray.
static void store_primary(IncomingLanes *lanes, const Scene *scene, const WideRays *rays) {
    store_lanes(&lanes->origin, rays->origin);
    store_lanes(&lanes->direction, rays->direction);
    // #region primary_weight
    store_lanes(&lanes->weight, wide3((float3)(1.0f)));
    // #endregion primary_weight
    lanes->depth.wide = 0;
    store_lanes(&lanes->absorption, wide3((float3)(0.0f)));
    if (HAS_MEDIA) {
        lanes->media.wide = scene->eye_media;
        store_lanes(&lanes->absorption, wide3(XYZ(medium_at(scene, scene->eye_media).absorption)));
    }
}

static PendingRay get_incoming(const IncomingLanes *lanes, const int lane) {
    PendingRay pending;
    pending.ray.origin = get_lane(&lanes->origin, lane);
    pending.ray.direction = get_lane(&lanes->direction, lane);
    pending.weight = get_lane(&lanes->weight, lane);
    pending.depth = lanes->depth.lane[lane];
    pending.media = HAS_MEDIA ? lanes->media.lane[lane] : 0;
    pending.absorption = get_lane(&lanes->absorption, lane);
    return pending;
}

static void put_incoming(IncomingLanes *lanes, const int lane, const PendingRay *pending) {
    put_lane(&lanes->origin, lane, pending->ray.origin);
    put_lane(&lanes->direction, lane, pending->ray.direction);
    put_lane(&lanes->weight, lane, pending->weight);
    lanes->depth.lane[lane] = pending->depth;
    if (HAS_MEDIA) {
        lanes->media.lane[lane] = pending->media;
    }
    put_lane(&lanes->absorption, lane, pending->absorption);
}
// #endregion incoming

// #region wide_shade
// Where nothing bounces, no lane needs a stack and counts of its own.
#define HAS_BOUNCES (HAS_REFLECTION || HAS_DIELECTRIC)
#define BOUNCE_LANES (HAS_BOUNCES ? WIDTH : 1)

// What is there where a packet's rays have hit, and of each whether light that comes straight from the
// lights counts there, and with what weight in the pixel. The rays for what else it sends on go onto
// the lane's stack.
static void shade_packet(const Scene *scene, const WideRays *rays, const WideHits *hits,
                         const IncomingLanes *incoming, RayStack *stacks, RayCounts *counts,
                         WideSurfaces *surfaces, WideInt *lit, Wide3 *weights, TEXTURES textures) {
    HitLanes hit_lanes;
    store_hits(&hit_lanes, rays->t_max, hits);
    SurfaceLanes surface_lanes;
    for (int lane = 0; lane < WIDTH; ++lane) {
        const Hit hit = get_hit(&hit_lanes, lane);
        if (hit.shape != SHAPE_NONE) {
            const PendingRay pending = get_incoming(incoming, lane);
            const Surface fetched = fetch_surface(scene, pending.ray, hit);
            put_surface(&surface_lanes, lane, &fetched);
        }
    }
    *surfaces = finish_surfaces(rays, &surface_lanes);
    store_surfaces(&surface_lanes, surfaces);
    LanesInt lit_lanes;
    Lanes3 weight_lanes;
    for (int lane = 0; lane < WIDTH; ++lane) {
        const Hit hit = get_hit(&hit_lanes, lane);
        float3 weight = 0.0f;
        lit_lanes.lane[lane] = 0;
        if (hit.shape != SHAPE_NONE) {
            const PendingRay pending = get_incoming(incoming, lane);
            const Surface surface = get_surface(&surface_lanes, lane);
            lit_lanes.lane[lane] = shade(scene, &pending, hit, &surface, &weight, &stacks[lane % BOUNCE_LANES],
                                         &counts[lane % BOUNCE_LANES], textures);
            if (HAS_SMOOTH_MESH && hit.shape == SHAPE_TRIANGLE) {
                put_lane(&surface_lanes.position, lane, surface.position + lift_off_facet(scene, &surface, hit));
            }
        }
        put_lane(&weight_lanes, lane, weight);
    }
    if (HAS_SMOOTH_MESH) {
        surfaces->position = load_lanes(&surface_lanes.position);
    }
    *lit = lit_lanes.wide != 0;
    *weights = load_lanes(&weight_lanes);
}

// What is left of it where a ray ends in no surface.
static Wide3 background_light(const Scene *scene, const IncomingLanes *incoming) {
    Lanes3 weights = incoming->weight;
    for (int lane = 0; HAS_MEDIA && lane < WIDTH; ++lane) {
        const float3 left = transmittance(get_lane(&incoming->absorption, lane), MAXFLOAT);
        put_lane(&weights, lane, get_lane(&weights, lane) * left);
    }
    return wide_product(load_lanes(&weights), wide3(XYZ(scene->background)));
}

// One ray of each lane: adds the light that its hit sends on at once.
static void trace_rays(const Scene *scene, WideRays *rays, const IncomingLanes *incoming,
                       RayStack stacks[][BOUNCE_LANES], RayCounts counts[][BOUNCE_LANES], Wide3 *colors,
                       WideInt *shadow_rays, TEXTURES textures) {
    WideHits hits[PACKETS];
    closest_hits(scene, rays, hits);
    WideSurfaces surfaces[PACKETS];
    WideInt lit[PACKETS];
    Wide3 weights[PACKETS];
    for (int packet = 0; packet < PACKETS; ++packet) {
        const Wide3 background = background_light(scene, &incoming[packet]);
        const WideInt misses =  // not asked by distance < INFINITY: relaxed math may take that for true
            (hits[packet].shape == SHAPE_NONE) & (rays[packet].t_max > 0.0f);
        colors[packet] = wide_sum(colors[packet], masked(misses, background));
        lit[packet] = 0;
        if (any_lane(hits[packet].shape != SHAPE_NONE)) {
            shade_packet(scene, &rays[packet], &hits[packet], &incoming[packet], stacks[packet], counts[packet],
                         &surfaces[packet], &lit[packet], &weights[packet], textures);
        }
    }
    add_direct_light(scene, surfaces, lit, weights, colors, shadow_rays);
}
// #endregion wide_shade

// #region wide_trace
// The next ray of each lane's stack. False when none has one.
static bool pop_rays(RayStack *stacks, IncomingLanes *incoming, WideRays *rays) {
    Lanes t_max_each;
    bool any = false;
    for (int lane = 0; lane < WIDTH; ++lane) {
        t_max_each.lane[lane] = -1.0f;
        if (stacks[lane].count > 0) {
            const PendingRay next = pop_ray(&stacks[lane]);
            put_incoming(incoming, lane, &next);
            t_max_each.lane[lane] = INFINITY;
            any = true;
        }
    }
    rays->origin = load_lanes(&incoming->origin);
    rays->direction = load_lanes(&incoming->direction);
    rays->t_max = t_max_each.wide;
    return any;
}

// As trace, of all packets' primary rays; `sum` comes empty.
static void trace_packets(const Scene *scene, WideRays *rays, Wide3 *colors, RayCounts *sum, TEXTURES textures) {
    IncomingLanes incoming[PACKETS];
    RayStack stacks[PACKETS][BOUNCE_LANES];
    RayCounts counts[PACKETS][BOUNCE_LANES];
    for (int packet = 0; packet < PACKETS; ++packet) {
        store_primary(&incoming[packet], scene, &rays[packet]);
        for (int lane = 0; lane < BOUNCE_LANES; ++lane) {
            stacks[packet][lane].count = 0;
            counts[packet][lane] = *sum;
        }
        colors[packet] = wide3((float3)(0.0f));
    }
    WideInt shadow_rays = 0;
    bool any = true;
    while (any) {
        trace_rays(scene, rays, incoming, stacks, counts, colors, &shadow_rays, textures);
        any = false;
        for (int packet = 0; HAS_BOUNCES && packet < PACKETS; ++packet) {
            any |= pop_rays(stacks[packet], &incoming[packet], &rays[packet]);
        }
    }
    sum->shadow = sum_of_lanes(shadow_rays);
    for (int packet = 0; packet < PACKETS; ++packet) {
        for (int lane = 0; lane < BOUNCE_LANES; ++lane) {
            const RayCounts of_lane = counts[packet][lane];
            sum->reflection += of_lane.reflection;
            sum->refraction += of_lane.refraction;
            sum->dropped += of_lane.dropped;
            sum->cut_off += of_lane.cut_off;
            sum->cut_off_weight = max(sum->cut_off_weight, of_lane.cut_off_weight);
        }
    }
}
// #endregion wide_trace
