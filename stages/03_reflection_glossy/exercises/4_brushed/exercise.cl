// SPDX-License-Identifier: MIT
// #stub
// Exercise 03.4: the stack, and what a reflecting surface puts onto it.
// #solution
// Exercise 03.4, solved: a bundle of rays for the first reflection, and room for it.
// #end

// kernels/ray_stack.cl
// #region stack
#define RAYS 32

// #stub
typedef struct RayStack {
    int count;
    PendingRay rays[STACK_SIZE];  // your turn
} RayStack;
// #solution
// All but one of a bundle can be left waiting while the last is followed; its path has no branches.
typedef struct RayStack {
    int count;
    PendingRay rays[RAYS - 1 + STACK_SIZE];
} RayStack;
// #end
// #endregion stack

// kernels/reflection.cl
// #region spawn_reflected
#define ROUGHNESS 0.12f
#define GOLDEN_ANGLE 2.3999632f

// #stub
// #solution
// Point `index` of RAYS on the unit disc, evenly spread (Vogel, A Better Way to Construct the Sunflower
// Head, 1979).
static float2 point_on_disc(const int index) {
    const float radius = sqrt(((float)index + 0.5f) / (float)RAYS);
    const float angle = GOLDEN_ANGLE * (float)index;
    return radius * (float2)(cos(angle), sin(angle));
}

// #end
static void spawn_reflected(RayStack *stack, const PendingRay *incoming, const Surface *surface,
                            const float3 weight, RayCounts *counts) {
    PendingRay reflected = *incoming;  // a reflection stays in its medium
    reflected.ray = reflected_ray(surface, incoming->ray.direction);
    reflected.weight = weight;
    ++reflected.depth;
// #stub
    push_ray(stack, reflected, &counts->reflection, counts);  // your turn
// #solution
    if (incoming->depth > 0) {
        push_ray(stack, reflected, &counts->reflection, counts);
        return;
    }
    reflected.weight /= (float)RAYS;
    const float3 middle = reflected.ray.direction;
    const float3 axis = fabs(middle.x) < 0.9f ? (float3)(1.0f, 0.0f, 0.0f) : (float3)(0.0f, 1.0f, 0.0f);
    const float3 across = normalize(cross(middle, axis));
    const float3 along = cross(middle, across);
    for (int i = 0; i < RAYS; ++i) {
        const float2 point = ROUGHNESS * point_on_disc(i);
        float3 direction = normalize(middle + point.x * across + point.y * along);
        if (dot(direction, surface->geometric_normal) < 0.0f) {
            direction = reflect(direction, surface->geometric_normal);
        }
        reflected.ray.direction = direction;
        push_ray(stack, reflected, &counts->reflection, counts);
    }
// #end
}
// #endregion spawn_reflected
