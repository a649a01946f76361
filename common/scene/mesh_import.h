// SPDX-License-Identifier: MIT
// Meshes of any format that Assimp reads.
#pragma once

#include <filesystem>

#include <glm/vec3.hpp>

#include "scene/scene.h"

namespace stagelight {

// How a [[meshes]] entry places its file: scaled, then rotated about x, then y,
// then z (degrees), then moved to position.
struct Placement {
    glm::dvec3 position{0, 0, 0};
    glm::dvec3 rotation{0, 0, 0};
    glm::dvec3 scale{1, 1, 1};
};

constexpr int material_of_file = -1;

// Appends the mesh in `file` to the scene: one Mesh, its vertices and triangles in
// world space (node transforms, then the placement), and unless `material` is an
// index into scene.materials, the file's own materials that its triangles use
// (diffuse colour, diffuse texture and what is cut out of it; texture paths are resolved beside the
// mesh, backslashes taken as slashes, then on the asset path). What the file has and the scene has
// not goes to scene.warnings, a line a kind. A mesh whose materials can't be seen has no triangles.
// Polygons are triangulated; points and lines are left out; normals are made where
// the file has none. Throws UserError at `where` for a file that is missing, not a
// mesh, without triangles, with an index out of range, with a position that is not
// finite, with a node graph that is no tree, or with more triangles than memory holds.
void import_mesh(Scene &scene, const std::filesystem::path &file, const Placement &placement,
                 int material, const SourceLocation &where);

}  // namespace stagelight
