// SPDX-License-Identifier: MIT
// Stage 09: a tree of boxes. A ray asks only the shapes whose boxes it meets, and no ray slips between triangles.
#include "tree.cl"  // new: the boxes of a node, and a ray's walk down the tree
#include "closest_hit.cl"
#include "any_hit.cl"
#include "box/robust.cl"     // new: how boxes are padded against rounding
#include "triangle/woop.cl"  // new: where a ray meets a triangle, watertight
#include "ray.cl"            // extended: a product and a sum, rounded once
#include "real.cl"           // extended: four numbers from memory
#include "render.cl"         // extended: the tree is an argument
#include "scene.cl"          // extended: the tree
#include "scene_types.h"     // extended: a node of the tree
