// SPDX-License-Identifier: MIT
// PLY files whose triangles are strips, of which Assimp's reader makes one triangle.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <assimp/mesh.h>

#include "scene/mesh_notes.h"

namespace stagelight {

// The file with its strips called faces: Assimp then gives a polygon for each. Nothing where there
// are none. Throws std::invalid_argument, with what was expected, for one with faces besides.
std::optional<std::string> prepared_ply(std::string_view bytes, MeshNotes &notes);

// Makes triangles of such polygons: each corner after the second ends one, and an index of -1 the
// strip.
void take_strips_apart(aiMesh &mesh);

}  // namespace stagelight
