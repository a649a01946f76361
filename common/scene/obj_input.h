// SPDX-License-Identifier: MIT
// OBJ files as other viewers read them, written so that Assimp's reader does the same.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "scene/mesh_notes.h"

namespace stagelight {

// Nothing if Assimp reads the text right as it is. Otherwise: `.5` has its 0; a `v` has 3 numbers,
// or 6 in every line if one of them has a colour (`v x y z r g b`; a lone fourth is w, which is
// dropped); faces name no texture coordinates or normals that some corner of them, or the file,
// lacks.
std::optional<std::string> prepared_obj(std::string_view text, MeshNotes &notes);

}  // namespace stagelight
