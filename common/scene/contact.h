// SPDX-License-Identifier: MIT
// Surfaces that lie in the same place.
#pragma once

#include "scene/scene.h"

namespace stagelight {

// Moves flat surfaces apart that are nearer to each other than rounding can tell, so that the scene
// itself says which one a ray meets first, whoever traces it. The later one in the file is moved,
// meshes being later than planes, along its own normal: a cube of glass sinks into the floor that
// it stands on, a picture comes before its wall. It is moved by 64 roundings, and less than a
// fiftieth of a pixel as the camera sees it. What can't be seen stays: where an opaque solid stands
// on an opaque surface, front to front. Of two equal spheres the later one grows.
void settle_contacts(Scene &scene);

}  // namespace stagelight
