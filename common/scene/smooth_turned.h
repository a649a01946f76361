// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "scene/parts.h"
#include "scene/scene.h"

namespace stagelight {

// Where a file has no normals, Assimp makes smooth ones, and leaves out a triangle that is the
// wrong way round. Makes them again around those that were `turned`, where they were made so.
// `places` is places_of the scene's vertices, and stays so.
void smooth_turned(Scene &scene, std::vector<std::uint32_t> &places, const Part &part,
                   const std::vector<bool> &turned);

}  // namespace stagelight
