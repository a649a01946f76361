// SPDX-License-Identifier: MIT
// Model no more than a scene needs: what it has is worked out once, and becomes the names that
// the kernels are built with.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "scene/scene.h"

namespace stagelight {

// Name and value of what is not 0, in a fixed order.
using SceneNeeds = std::vector<std::pair<std::string, int>>;

// `stage` is the number of the stage that draws: 01 knows neither materials nor lights.
SceneNeeds needs_of(const Scene &scene, int stage, int max_depth);

// Whether any triangle's material has a texture.
bool has_textured_mesh(const Scene &scene);

}  // namespace stagelight
