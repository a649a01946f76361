// SPDX-License-Identifier: MIT
#pragma once

#include "scene/scene.h"

namespace stagelight {

// Of dielectric triangles of one mesh that have the same three corners, keeps the first. Where two
// parts of a mesh touch, so that a wall of two faces would part glass from glass, keeps none.
void drop_doubled_faces(Scene &scene);

}  // namespace stagelight
