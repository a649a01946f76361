// SPDX-License-Identifier: MIT
// Introduced by stage 03; extended by 04 (absorption): OpenCL C knows no recursion, so the
// rays that are still to be traced wait on a stack of our own (paper, section 3).
#include "ray.cl"

// #region ray_stack
typedef struct PendingRay {
    Ray ray;
    float3 weight;  // what its light is multiplied by on the way to the pixel
    int depth;      // bounces so far
#if HAS_DIELECTRIC
    float3 absorption;  // of the medium that it runs in
#endif
} PendingRay;

// The host knows what a scene's rays can spawn: where each spawns one at most, one place
// will do; where a ray may split in two, one of each depth can be left waiting.
typedef struct RayStack {
    PendingRay rays[STACK_SIZE];
    int count;
} RayStack;

static PendingRay primary_ray(const Ray ray) {
    PendingRay primary;
    primary.ray = ray;
    primary.weight = (float3)(1.0f);
    primary.depth = 0;
#if HAS_DIELECTRIC
    primary.absorption = (float3)(0.0f);
#endif
    return primary;
}

// Member by member: the compiler of Mesa 22.3.6 loses a struct within a struct that is put into an
// array as a whole.
static void copy_pending(PendingRay *to, const PendingRay *from) {
    to->ray.origin = from->ray.origin;
    to->ray.direction = from->ray.direction;
    to->weight = from->weight;
    to->depth = from->depth;
#if HAS_DIELECTRIC
    to->absorption = from->absorption;
#endif
}

// A ray beyond the depth limit is not traced, but it is counted.
static void push_ray(RayStack *stack, const PendingRay ray, uint *traced, uint *dropped) {
    if (ray.depth > MAX_DEPTH) {
        ++*dropped;
    } else {
        ++*traced;
        copy_pending(&stack->rays[stack->count++], &ray);
    }
}
// #endregion ray_stack
