// SPDX-License-Identifier: MIT
// Which triangles of a scene are dielectric.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/scene.h"

namespace stagelight {

bool is_dielectric(const Scene &scene, int material);

// For each mesh the indices of its dielectric triangles, ascending.
std::vector<std::vector<std::uint32_t>> dielectric_triangles(const Scene &scene);

}  // namespace stagelight
