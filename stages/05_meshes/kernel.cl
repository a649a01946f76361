// SPDX-License-Identifier: MIT
// Stage 05: meshes. A triangle is one more shape, of which there are suddenly a thousand, every
// one of them tried by every ray: stage 09 is the cure.
#include "triangle.cl"    // new: Möller–Trumbore, normals blended between the corners
#include "each_shape.cl"  // extended: triangles are seen, and cast shadows
#include "closest_hit.cl"
#include "any_hit.cl"
#include "ray.cl"         // extended: where on a triangle a hit is
#include "render.cl"      // extended: the meshes are arguments
#include "scene.cl"       // extended: meshes
#include "scene_types.h"  // extended: triangles
#include "surface.cl"     // extended: triangles
