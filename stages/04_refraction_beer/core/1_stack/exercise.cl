// SPDX-License-Identifier: MIT
// Core exercise 04 stack: the rays that wait for their turn.

// kernels/ray_stack.cl
// #region push
    // your turn: given are stack, ray, traced and counts
    if (ray.depth <= MAX_DEPTH && stack->count == 0) {
        ++*traced;
        copy_pending(&stack->rays[place_of(stack, stack->count++)], &ray);
    }
// #endregion push

// #region pop_ray
static PendingRay pop_ray(RayStack *stack) {
    return stack->rays[place_of(stack, --stack->count)];  // as it should be: what does it ask of push_ray?
}
// #endregion pop_ray
