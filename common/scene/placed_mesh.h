// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <assimp/mesh.h>
#include <glm/mat4x4.hpp>

#include "scene/mesh_materials.h"
#include "scene/mesh_model.h"
#include "scene/scene.h"

namespace stagelight {

// Appends the triangles of a mesh, as a node places it, to the scene's last Mesh; those without an
// area are left out. False if a position is not finite.
bool append_placed(Scene &scene, const aiMesh &mesh, const glm::dmat4 &to_world, const Look &look);

// Appends a copy, all of which wears `material` if that is given, to the scene's last Mesh. False
// if a vertex lands too far away to be drawn.
bool append_copy(Scene &scene, const MeshModel &model, const glm::dmat4 &to_world,
                 const std::optional<int> &material);

}  // namespace stagelight
