// SPDX-License-Identifier: MIT
// Exercise 05.1: the edges of each triangle, drawn on it.

// kernels/shade.cl
// #region surface_color
#define WIRE_WIDTH 0.003f  // from the edge to the side, scene units
#define WIRE_COLOR (float3)(0.05f, 0.1f, 0.2f)
    float3 color = XYZ(material.color);
    if (hit.shape == SHAPE_TRIANGLE) {
        // your turn
    }
    float3 weight = incoming->weight * color;
// #endregion surface_color
