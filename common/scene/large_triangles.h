// SPDX-License-Identifier: MIT
// Triangles so large that float would lose what stands on them.
#pragma once

#include "scene/scene.h"

namespace stagelight {

// In float, where a triangle is hit is known to a few millionths of its size: on a ground of 20 km
// a coin would have no shadow. So a triangle that is more than 24 times as long as another object
// and the way to it is cut into smaller ones, the smaller the nearer they are; for the eye, the
// smallest object's size counts. The surface stays the same, and closed (Rivara, Algorithms for
// Refining Triangular Grids Suitable for Adaptive and Multigrid Techniques, 1984). Other scenes
// stay as they are.
void cut_large_triangles(Scene &scene);

}  // namespace stagelight
