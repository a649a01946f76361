// SPDX-License-Identifier: MIT
// Introduced by stage 03; extended by 04 (absorption) and 11 (importance cutoff): OpenCL C knows no recursion,
// so the rays that are still to be traced wait on a stack of our own (paper, section 3).
#include "ray.cl"

// #region ray_stack
// #region pending_ray
typedef struct PendingRay {
    Ray ray;
    float3 weight;      // what its light is multiplied by on the way to the pixel
    int depth;          // bounces so far
    uint media;         // the dielectrics that it is in, a bit for each
    float3 absorption;  // of the medium that it runs in
} PendingRay;
// #endregion pending_ray

// #region stack
// The host knows what a scene's rays can spawn: where each spawns one at most, one place
// will do; where a ray may split in two, one of each depth can be left waiting.
typedef struct RayStack {
    int count;
    PendingRay rays[STACK_SIZE];
} RayStack;
// #endregion stack

// Where the n-th ray is kept. If there is one place only, the compiler keeps it in registers.
static int place_of(const RayStack *stack, const int n) {
    return sizeof(stack->rays) > sizeof(stack->rays[0]) ? n : 0;
}

static PendingRay primary_ray(const Ray ray) {
    PendingRay primary;
    primary.ray = ray;
    primary.weight = (float3)(1.0f);
    primary.depth = 0;
    primary.media = 0;
    primary.absorption = (float3)(0.0f);
    return primary;
}

// Member by member: the compiler of Mesa 22.3.6 loses a struct within a struct that is put into an
// array as a whole.
static void copy_pending(PendingRay *to, const PendingRay *from) {
    to->ray.origin = from->ray.origin;
    to->ray.direction = from->ray.direction;
    to->weight = from->weight;
    to->depth = from->depth;
    if (HAS_DIELECTRIC) {
        to->absorption = from->absorption;
    }
    if (HAS_MEDIA) {
        to->media = from->media;
    }
}

// #region importance_cutoff
// A ray is not worth its way when it can't bring a pixel a step of an 8-bit picture. What all such
// rays of a pixel could have brought is added up, rounded up, so that their error is known.
static bool is_cut_off(const PendingRay *ray, RayCounts *counts) {
    const float largest = max(ray->weight.x, max(ray->weight.y, ray->weight.z));
    if (largest * CUTOFF_ONE_IN >= 1.0f) {
        return false;
    }
    ++counts->cut_off;
    counts->cut_off_weight += convert_uint_rtp(largest * CUT_OFF_WEIGHT_ONE);
    return true;
}
// #endregion importance_cutoff

// #region push_ray
// A ray that is cut off, or is beyond the depth limit, is not traced, but it is counted.
static void push_ray(RayStack *stack, const PendingRay ray, uint *traced, RayCounts *counts) {
    if (CUTOFF_ONE_IN > 0 && is_cut_off(&ray, counts)) {
        return;
    }
    // #region push
    if (ray.depth > MAX_DEPTH) {
        ++counts->dropped;
    } else {
        ++*traced;
        copy_pending(&stack->rays[place_of(stack, stack->count++)], &ray);
    }
    // #endregion push
}
// #endregion push_ray

// #region pop_ray
static PendingRay pop_ray(RayStack *stack) {
    return stack->rays[place_of(stack, --stack->count)];
}
// #endregion pop_ray
// #endregion ray_stack
