// SPDX-License-Identifier: MIT
// Core exercise 01 closest_hit: of all that a ray meets, the nearest.

// kernels/ray.cl
// #region keep_closer
// Whether what is at `distance` is nearer than all before it.
static bool keep_closer(Hit *closest, const float distance, const Shape shape, const int index) {
    if (!(distance < INFINITY)) {  // your turn
        return false;
    }
    closest->distance = distance;
    closest->shape = shape;
    closest->index = index;
    return true;
}
// #endregion keep_closer

// kernels/each_shape.cl
// #region each_sphere
    // your turn: scene, ray and closest are given
// #endregion each_sphere
