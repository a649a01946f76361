// SPDX-License-Identifier: MIT
// The materials that a mesh file brings along.
#pragma once

#include <filesystem>
#include <map>
#include <utility>

#include <assimp/scene.h>

#include "scene/scene.h"

namespace stagelight {

// Which material a mesh wears, and which of its sets of texture coordinates that uses.
struct Look {
    int material = 0;
    unsigned coordinates = 0;
};

// Appends the materials of a file to a scene, each when it is first asked for.
class MeshMaterials {
public:
    // `where` is the [[meshes]] entry's place.
    MeshMaterials(Scene &scene, const aiScene &meshes, std::filesystem::path file,
                  SourceLocation where);

    Look look_of(const aiMesh &mesh);

private:
    Look add(const aiMaterial &material, bool with_texture);
    int load(const aiString &texture);

    Scene &scene_;
    const aiScene &meshes_;
    std::filesystem::path file_;
    SourceLocation where_;
    // A mesh without texture coordinates wears the colour alone.
    std::map<std::pair<unsigned, bool>, Look> looks_;
};

}  // namespace stagelight
