// SPDX-License-Identifier: MIT
// MTL files as other viewers read them, written so that Assimp's reader does the same.
#pragma once

#include <string>
#include <string_view>

#include "scene/mesh_notes.h"

namespace stagelight {

// The materials' names, Kd, d and pictures of colour and alpha: all that a picture shows. What
// else they say, and how textures are moved (-o, -s), goes to `notes`.
std::string prepared_mtl(std::string_view text, MeshNotes &notes);

}  // namespace stagelight
