// SPDX-License-Identifier: MIT
// Core exercise 05 normal: what makes a mesh look round.

// kernels/triangle.cl
// #region blended_normal
    surface->normal = XYZ(scene->vertex_normals[triangle.vertices[0]]);  // your turn
// #endregion blended_normal
