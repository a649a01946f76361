// SPDX-License-Identifier: MIT
// Positions that vertices share.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/scene.h"

namespace stagelight {

// For each vertex the number of its position. Vertices at exactly the same position get the same
// number, whatever their normals and texture coordinates are; 0 and -0 are the same.
std::vector<std::uint32_t> places_of(const std::vector<Vertex> &vertices);

}  // namespace stagelight
