// SPDX-License-Identifier: MIT
// Whether a mesh has an inside, which Beer's law asks for.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace stagelight {

// One line for each mesh of dielectric material that is not closed: its place in the scene's file,
// and how many of its edges have not two triangles, or four as where two of its parts touch. Edges
// are told by the positions of their ends, exactly: a mesh is closed across the seams of its
// normals and texture coordinates.
std::vector<std::string> open_dielectric_meshes(const Scene &scene);

}  // namespace stagelight
