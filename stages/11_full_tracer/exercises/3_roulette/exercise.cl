// SPDX-License-Identifier: MIT
// #stub
// Exercise 11.3: which rays to follow, by chance.
// #solution
// Exercise 11.3, solved: who survives carries what those who died would have brought.
// #end

// kernels/ray_stack.cl
// #region push_ray
#define ROULETTE_BELOW 0.2f

// From 0 to 1, by a hash of the direction's bits (Jarzynski and Olano, Hash Functions for GPU Rendering,
// Journal of Computer Graphics Techniques, 2020: pcg3d).
static float random_of(const Ray ray) {
    uint x = as_uint(ray.direction.x) * 1664525u + 1013904223u;
    uint y = as_uint(ray.direction.y) * 1664525u + 1013904223u;
    uint z = as_uint(ray.direction.z) * 1664525u + 1013904223u;
    x += y * z;
    y += z * x;
    z += x * y;
    x ^= x >> 16;
    y ^= y >> 16;
    z ^= z >> 16;
    x += y * z;
    return (float)(x >> 8) * 5.9604645e-8f;  // 24 bits, of 2^-24 each
}

// #stub
// Whether the ray is traced; it then may have another weight.
static bool survives(PendingRay *ray) {
    return true;  // your turn
}
// #solution
// Whether the ray is traced; it then carries the weight of those that are not (Arvo and Kirk, Particle Transport
// and Image Synthesis, 1990).
static bool survives(PendingRay *ray) {
    const float largest = max(ray->weight.x, max(ray->weight.y, ray->weight.z));
    const float probability = min(largest / ROULETTE_BELOW, 1.0f);
    if (random_of(ray->ray) >= probability) {
        return false;
    }
    ray->weight /= probability;
    return true;
}
// #end

// A ray that has died, or is beyond the depth limit, is not traced, but it is counted.
static void push_ray(RayStack *stack, const PendingRay ray, uint *traced, RayCounts *counts) {
    PendingRay survivor = ray;
    if (!survives(&survivor)) {
        ++counts->cut_off;
        return;
    }
    if (survivor.depth > MAX_DEPTH) {
        ++counts->dropped;
    } else {
        ++*traced;
        copy_pending(&stack->rays[stack->count++], &survivor);
    }
}
// #endregion push_ray
