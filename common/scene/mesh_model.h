// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "scene/scene.h"

namespace stagelight {

// What a mesh file holds, in its own space: [[meshes]] entries place copies of it.
struct MeshModel {
    std::vector<Vertex> vertices;
    std::vector<Triangle> triangles;       // of these vertices
    bool has_texture_coordinates = false;  // each of its meshes
};

}  // namespace stagelight
