// SPDX-License-Identifier: MIT
// Stage 05: meshes. A triangle is one more shape, of which there are suddenly a thousand, every
// one of them tried by every ray: stage 09 is the cure.
#include "any_hit.cl"      // extended: triangles cast shadows
#include "closest_hit.cl"  // extended: triangles are seen
#include "render.cl"
#include "triangle.cl"  // new: Möller–Trumbore, normals blended between the corners
