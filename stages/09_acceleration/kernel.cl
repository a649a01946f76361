// SPDX-License-Identifier: MIT
// Stage 09: a tree of boxes. What is not in a box that a ray meets need not be tried.
#include "any_hit.cl"      // extended: the tree instead of the loop
#include "bvh.cl"          // new: slabs, and the walk down the tree
#include "closest_hit.cl"  // extended: the tree instead of the loop
#include "render.cl"
