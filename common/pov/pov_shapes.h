// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "pov/pov_media.h"
#include "scene/scene.h"

namespace stagelight::pov {

// The spheres, planes and meshes, with the materials that `declaration` made.
std::string shapes(const Scene &scene, const Media &media);

}  // namespace stagelight::pov
