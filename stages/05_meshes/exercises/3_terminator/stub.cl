// SPDX-License-Identifier: MIT
// Exercise 05.3: where shadow rays start on a mesh that stands for something round.

// kernels/trace.cl
// #region direct
                Surface rounded = surface;
                if (hit.shape == SHAPE_TRIANGLE) {
                    // your turn: rounded.position
                }
                color += weight * direct_light(scene, &rounded, counts);
// #endregion direct
