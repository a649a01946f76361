// SPDX-License-Identifier: MIT
// Exercise 06.1: what rays see that hit nothing.

// kernels/trace.cl
// #region miss
            float3 sky = XYZ(scene->background);  // your turn
            color += incoming.weight * sky;
// #endregion miss
