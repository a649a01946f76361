// SPDX-License-Identifier: MIT
// Scenes of any size that look the same at every size.
#pragma once

#include "scene/scene.h"

namespace stagelight::bench {

// A ring with waves on it, of 4 n^2 triangles, before a camera that does not move: more triangles
// make it smoother, not larger. With one point light.
Scene ring(int n);

// The ring, lit by `count` lights all around.
Scene ring_in_lights(int count);

// A ball between two mirrors that face each other, seen from between them: each ray but those to
// the ball goes on for `depth` bounces.
Scene facing_mirrors(int depth);

}  // namespace stagelight::bench
