// SPDX-License-Identifier: MIT
// The smooth patches of the meshes, for the edge mask.
#pragma once

#include <vector>

#include "scene/scene.h"

namespace stagelight::reference {

// For each triangle the number of its patch: triangles are of one patch when a chain of
// shared corners joins them, corners at which position, normal, material and, under a texture,
// texture coordinates agree, so that the shading runs on from one to the other.
std::vector<int> smooth_patches(const Scene &scene);

}  // namespace stagelight::reference
