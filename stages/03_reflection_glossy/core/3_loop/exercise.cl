// SPDX-License-Identifier: MIT
// Core exercise 03 loop: from one ray to all that it leads to.

// kernels/trace.cl
// #region next_ray
    {  // your turn
        const PendingRay incoming = pop_ray(&stack);
        const Hit hit = closest_hit(scene, incoming.ray);
// #endregion next_ray

// #region add_background
            color = light;  // your turn
// #endregion add_background

// #region add_direct
                color = direct_light(scene, &surface, counts);  // your turn
// #endregion add_direct
