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

static void start_stack(RayStack *stack, const Ray primary) {
    PendingRay ray;
    ray.ray = primary;
    ray.weight = (float3)(1.0f);
    ray.depth = 0;
#if HAS_DIELECTRIC
    ray.absorption = (float3)(0.0f);
#endif
    stack->rays[0] = ray;
    stack->count = 1;
}

// A ray beyond the depth limit is not traced, but it is counted.
static void push_ray(RayStack *stack, const PendingRay ray, uint *traced, uint *dropped) {
    if (ray.depth > MAX_DEPTH) {
        ++*dropped;
    } else {
        ++*traced;
        stack->rays[stack->count++] = ray;
    }
}
// #endregion ray_stack
