// SPDX-License-Identifier: MIT
// What a mesh file says that has no place in what Assimp makes of it.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>

#include <glm/mat3x3.hpp>

namespace stagelight {

struct MaterialNotes {
    // Of the texture coordinates, with v going down, before the texture is looked up.
    glm::dmat3 texture_transform{1};
    // What the material has and no picture of ours, such as "a normal map".
    std::set<std::string> not_drawn;
};

struct MeshNotes {
    std::map<std::string, MaterialNotes> materials;  // by the name that Assimp gives them
    std::set<std::string> warnings;                  // of the whole file
    std::size_t vertices_in_file = 0;  // of an OBJ: Assimp keeps those alone that faces use
    bool has_strips = false;           // the polygons of a PLY are triangle strips
    bool is_gltf = false;              // whose vertex colours are linear
    bool is_collada = false;           // whose transparency exporters disagree on
    bool is_fbx = false;               // which says which way is up
};

}  // namespace stagelight
