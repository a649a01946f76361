// SPDX-License-Identifier: MIT
// #stub
// Exercise 05.1: the edges of each triangle, drawn on it.
// #solution
// Exercise 05.1, solved: a weight is the distance from the edge opposite, in heights of the triangle.
// #end

// kernels/shade.cl
// #region surface_color
#define WIRE_WIDTH 0.003f  // from the edge to the side, scene units
#define WIRE_COLOR (float3)(0.05f, 0.1f, 0.2f)
    float3 color = XYZ(material.color);
    if (hit.shape == SHAPE_TRIANGLE) {
// #stub
        // your turn
// #solution
        const Edges edges = triangle_edges(scene, hit.index);
        const float b = hit.barycentric.x;
        const float c = hit.barycentric.y;
        // A height is twice the area over its edge.
        const float twice_area = length(cross(edges.b, edges.c));
        const float3 from_edges =
            twice_area * (float3)((1.0f - b - c) / length(edges.c - edges.b), b / length(edges.c),
                                  c / length(edges.b));
        if (min(from_edges.x, min(from_edges.y, from_edges.z)) < WIRE_WIDTH) {
            color = WIRE_COLOR;
        }
// #end
    }
    float3 weight = incoming->weight * color;
// #endregion surface_color
