// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "scene/scene.h"

namespace stagelight {

// Moves the later one of each two faces that touch (touching_faces), as side_of_later says, until
// it is contact_margin before the other. Vertices at one position of a part are moved together, so
// that what is closed stays closed. `raised` is how far each plane will be moved along its normal.
void move_touching_faces(Scene &scene, const std::vector<double> &raised);

}  // namespace stagelight
