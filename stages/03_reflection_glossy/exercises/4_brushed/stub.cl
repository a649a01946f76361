// SPDX-License-Identifier: MIT
// Exercise 03.4: the stack, and what a reflecting surface puts onto it.

// kernels/ray_stack.cl
// #region stack
#define RAYS 32

typedef struct RayStack {
    int count;
    PendingRay rays[STACK_SIZE];  // your turn
} RayStack;
// #endregion stack

// kernels/reflection.cl
// #region spawn_reflected
#define ROUGHNESS 0.12f
#define GOLDEN_ANGLE 2.3999632f

static void spawn_reflected(RayStack *stack, const PendingRay *incoming, const Surface *surface,
                            const float3 weight, RayCounts *counts) {
    PendingRay reflected = *incoming;  // a reflection stays in its medium
    reflected.ray = reflected_ray(surface, incoming->ray.direction);
    reflected.weight = weight;
    ++reflected.depth;
    push_ray(stack, reflected, &counts->reflection, counts);  // your turn
}
// #endregion spawn_reflected
