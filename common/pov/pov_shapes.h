// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "scene/scene.h"

namespace stagelight::pov {

// The spheres, planes and meshes, with the materials that `declaration` made.
std::string shapes(const Scene &scene);

}  // namespace stagelight::pov
