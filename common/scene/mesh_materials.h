// SPDX-License-Identifier: MIT
// The materials that a mesh file brings along.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <assimp/scene.h>
#include <glm/mat3x3.hpp>

#include "scene/mesh_file.h"
#include "scene/scene.h"
#include "scene/texture_set.h"

namespace stagelight {

// Which material a mesh wears, and what of the mesh that uses.
struct Look {
    int material = 0;
    unsigned coordinates = 0;         // of its sets of texture coordinates
    glm::dmat3 texture_transform{1};  // of them, v going down
    bool has_colors = false;          // of the vertices
    bool are_colors_linear = false;   // else they are sRGB
    bool is_seen = true;              // else nothing of the mesh is there
};

// Appends the materials of a file to a scene, each when it is first asked for.
class MeshMaterials {
public:
    // `where` is the [[meshes]] entry's place. Pictures are looked for in the folders of the files
    // that Assimp asked for, as companion_file.h says.
    MeshMaterials(Scene &scene, const MeshFile &meshes, std::filesystem::path file,
                  SourceLocation where);

    Look look_of(const aiMesh &mesh);

    // Warns of what the file and the materials that were asked for have, and the picture has not:
    // of pictures that are missing, and of those that can't be read, one line each.
    void warn();

private:
    void add(const aiMaterial &material, bool with_texture, Look &look);
    int texture_of(const aiMaterial &material, Look &look);
    int with_mask(int texture, const aiString &color, const aiString &mask, Wraps wraps,
                  std::size_t known_textures);
    bool is_seen(const aiMaterial &material);
    void set_alpha(const aiMaterial &material, Material &added);
    void note_what_is_lost(const aiMaterial &material);
    void warn_of_pictures() const;
    int load(const aiString &texture, Wraps wraps);
    int load_file(const std::string &name, Wraps wraps);
    int load_embedded(const aiTexture &texture, int index, Wraps wraps);
    SourceLocation in_mesh() const;

    Scene &scene_;
    const aiScene &meshes_;
    const MeshNotes &notes_;
    std::filesystem::path file_;
    std::vector<std::filesystem::path> folders_;
    SourceLocation where_;
    std::size_t known_materials_;          // before the file's
    std::set<std::string> failed_;         // the names of textures that can't be had
    std::vector<std::string> missing_;     // those that aren't there
    std::vector<std::string> unreadable_;  // what is wrong with the others
    // A mesh without texture coordinates wears the colour alone.
    std::map<std::tuple<unsigned, unsigned, bool, bool>, Look> looks_;
    std::map<std::pair<std::string, std::string>, std::filesystem::path>
        masked_;  // textures' `file`
    std::set<std::string> not_drawn_;
    std::set<std::string> warnings_;
};

}  // namespace stagelight
