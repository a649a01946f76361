// SPDX-License-Identifier: MIT
// Meshes of any format that Assimp reads.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>

#include <glm/vec3.hpp>

#include "scene/mesh_model.h"
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

// Appends meshes to a scene, and reads each file once, however many entries name it.
class MeshImporter {
public:
    explicit MeshImporter(Scene &scene) : scene_(scene) {}

    // Appends the mesh in `file` to the scene: one Mesh, its vertices and triangles in
    // world space (node transforms, then the placement), and unless `material` is an
    // index into scene.materials, when its file is first read, the file's own materials that
    // its triangles use (diffuse colour, diffuse texture and what is cut out of it). What the file
    // has and the scene has not goes to scene.warnings, a line a kind. A mesh whose materials can't
    // be seen has no triangles.
    // Polygons are triangulated; points and lines are left out; normals are made where
    // the file has none. Throws UserError at `where` for a file that is missing, not a
    // mesh, without triangles, with an index out of range, with a position that is not
    // finite, with a node graph that is no tree, or with more triangles than memory holds.
    void add(const std::filesystem::path &file, const Placement &placement, int material,
             const SourceLocation &where);

private:
    const MeshModel &model_of(const std::filesystem::path &file, int material,
                              const SourceLocation &where);
    MeshModel read(const std::filesystem::path &file, int material, const SourceLocation &where);

    Scene &scene_;
    // By canonical path, and whether it is to wear its own materials.
    std::map<std::pair<std::string, bool>, MeshModel> models_;
};

}  // namespace stagelight
