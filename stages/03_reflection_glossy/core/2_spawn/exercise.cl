// SPDX-License-Identifier: MIT
// Core exercise 03 spawn: the ray that a mirror sends on.

// kernels/reflection.cl
// #region spawn_reflected
static void spawn_reflected(RayStack *stack, const PendingRay *incoming, const Surface *surface,
                            const float3 weight, RayCounts *counts) {
    // your turn
}
// #endregion spawn_reflected
