// SPDX-License-Identifier: MIT
#pragma once

#include <assimp/mesh.h>
#include <glm/mat4x4.hpp>

#include "scene/mesh_materials.h"
#include "scene/scene.h"

namespace stagelight {

// Appends the triangles of a mesh, as a node places it, to the scene's last Mesh; those without an
// area are left out. False if a vertex lands too far away to be drawn.
bool append_placed(Scene &scene, const aiMesh &mesh, const glm::dmat4 &to_world, const Look &look);

}  // namespace stagelight
