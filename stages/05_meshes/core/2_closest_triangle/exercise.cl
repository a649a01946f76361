// SPDX-License-Identifier: MIT
// Core exercise 05 closest_triangle: of all triangles, the nearest.

// kernels/each_shape.cl
// #region closest_triangle
    // your turn: scene, ray and closest are given
// #endregion closest_triangle
