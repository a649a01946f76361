// SPDX-License-Identifier: MIT
#include "scene/mesh_materials.h"

#include <algorithm>
#include <sstream>
#include <string>

#include <assimp/material.h>

#include "scene/asset_path.h"
#include "scene/picture.h"
#include "scene/texture_set.h"

namespace stagelight {

namespace fs = std::filesystem;

namespace {

// Not finite becomes 0.
double share(float value) {
    return std::min(std::max(0.0, double{value}), 1.0);
}

glm::dvec3 color_of(const aiMaterial &material) {
    aiColor4D color(1, 1, 1, 1);
    if (material.Get(AI_MATKEY_COLOR_DIFFUSE, color) != aiReturn_SUCCESS) {
        material.Get(AI_MATKEY_BASE_COLOR, color);
    }
    return {share(color.r), share(color.g), share(color.b)};
}

// Beside the mesh by the path it names, or by file name, since paths are often those of the
// machine that made the mesh; else on the asset path.
fs::path find_texture(std::string name, const fs::path &mesh_file, const SourceLocation &where) {
    std::replace(name.begin(), name.end(), '\\', '/');
    fs::path beside = mesh_file.parent_path() / name;
    std::error_code unimportant;  // what can't be asked is not there for us
    if (fs::is_regular_file(beside, unimportant)) {
        return beside;
    }
    return find_asset(fs::path(name).filename().string(), mesh_file.parent_path(), where);
}

// A height of 0 means that the data are a file, `width` bytes of it.
Texture read_embedded(const aiTexture &texture, const fs::path &name, const SourceLocation &where) {
    if (texture.mHeight == 0) {
        std::istringstream stream(
            std::string(reinterpret_cast<const char *>(texture.pcData), texture.mWidth));
        return read_picture(stream, name, where);
    }
    require_texture_size(texture.mWidth, texture.mHeight, name, where);
    Texture raw{.file = name,
                .width = static_cast<int>(texture.mWidth),
                .height = static_cast<int>(texture.mHeight),
                .texels = {},
                .where = where};
    for (std::size_t i = 0; i < std::size_t{texture.mWidth} * texture.mHeight; ++i) {
        const aiTexel &texel = texture.pcData[i];
        raw.texels.insert(raw.texels.end(), {texel.r, texel.g, texel.b, texel.a});
    }
    return raw;
}

}  // namespace

MeshMaterials::MeshMaterials(Scene &scene, const aiScene &meshes, fs::path file,
                             SourceLocation where)
    : scene_(scene), meshes_(meshes), file_(std::move(file)), where_(std::move(where)) {}

Look MeshMaterials::look_of(const aiMesh &mesh) {
    const std::pair key{mesh.mMaterialIndex, mesh.HasTextureCoords(0)};
    if (const auto known = looks_.find(key); known != looks_.end()) {
        return known->second;
    }
    const Look look = add(*meshes_.mMaterials[mesh.mMaterialIndex], key.second);
    looks_.emplace(key, look);
    return look;
}

Look MeshMaterials::add(const aiMaterial &material, bool with_texture) {
    Material added;
    added.color = color_of(material);
    added.where = where_;
    Look look{.material = static_cast<int>(scene_.materials.size())};
    for (const aiTextureType type : {aiTextureType_DIFFUSE, aiTextureType_BASE_COLOR}) {
        aiString texture;
        if (with_texture && added.texture == no_texture
            && material.GetTexture(type, 0, &texture, nullptr, &look.coordinates)
                   == aiReturn_SUCCESS
            && texture.length > 0) {
            added.texture = load(texture);
        }
    }
    scene_.materials.push_back(added);
    return look;
}

int MeshMaterials::load(const aiString &texture) {
    const SourceLocation in_mesh{.file = to_string(where_) + ": texture of " + file_.string()};
    // No structured binding: Clang 14 lets no lambda have one.
    const std::pair found = meshes_.GetEmbeddedTextureAndIndex(texture.C_Str());
    if (!found.first) {
        return load_texture(scene_.textures, find_texture(texture.C_Str(), file_, in_mesh),
                            in_mesh);
    }
    const fs::path name = fs::canonical(file_).string() + '*' + std::to_string(found.second);
    return texture_once(scene_.textures, name,
                        [&] { return read_embedded(*found.first, name, in_mesh); });
}

}  // namespace stagelight
