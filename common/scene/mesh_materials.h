// SPDX-License-Identifier: MIT
// The materials that a mesh file brings along.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

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
    // `where` is the [[meshes]] entry's place. Pictures are looked for in `folders`, of which the
    // first is the file's, as companion_file.h says.
    MeshMaterials(Scene &scene, const aiScene &meshes, std::filesystem::path file,
                  std::vector<std::filesystem::path> folders, SourceLocation where);

    Look look_of(const aiMesh &mesh);

    // Adds a line to the scene's warnings for the pictures that are missing, and one for those that
    // can't be read: their materials are of one colour.
    void warn() const;

private:
    Look add(const aiMaterial &material, bool with_texture);
    int load(const aiString &texture);
    int load_file(const std::string &name);
    int load_embedded(const aiTexture &texture, int index);
    SourceLocation in_mesh() const;

    Scene &scene_;
    const aiScene &meshes_;
    std::filesystem::path file_;
    std::vector<std::filesystem::path> folders_;
    SourceLocation where_;
    std::set<std::string> failed_;         // the names of textures that can't be had
    std::vector<std::string> missing_;     // those that aren't there
    std::vector<std::string> unreadable_;  // what is wrong with the others
    // A mesh without texture coordinates wears the colour alone.
    std::map<std::pair<unsigned, bool>, Look> looks_;
};

}  // namespace stagelight
