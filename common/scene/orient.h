// SPDX-License-Identifier: MIT
// Which way round the triangles of a dielectric mesh are.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace stagelight {

// Turns the triangles of dielectric meshes so that their corners run counter-clockwise as seen from
// outside of the glass, and their vertices' normals point there. A closed part that lies inside
// another and is wound the other way round is a cavity, whose outside is its inside. One line for
// each mesh with edges where that can't be done, as on a Möbius strip or where three triangles
// meet. A mesh that is right is left as it is.
std::vector<std::string> orient_dielectrics(Scene &scene);

}  // namespace stagelight
