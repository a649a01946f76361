// SPDX-License-Identifier: MIT
#include "scene/mesh_materials.h"

#include <algorithm>
#include <optional>
#include <sstream>
#include <string>

#include <assimp/material.h>
#include <fmt/format.h>

#include "scene/companion_file.h"
#include "scene/errors.h"
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
                             std::vector<fs::path> folders, SourceLocation where)
    : scene_(scene), meshes_(meshes), file_(std::move(file)), folders_(std::move(folders)),
      where_(std::move(where)) {}

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
    const std::string name = texture.C_Str();
    if (failed_.contains(name)) {
        return no_texture;
    }
    int index = no_texture;
    try {
        // No structured binding: Clang 14 lets no lambda have one.
        const std::pair found = meshes_.GetEmbeddedTextureAndIndex(name.c_str());
        index = found.first ? load_embedded(*found.first, found.second) : load_file(name);
    } catch (const UserError &error) {
        unreadable_.emplace_back(error.what());
    }
    if (index == no_texture) {
        failed_.insert(name);
    }
    return index;
}

int MeshMaterials::load_embedded(const aiTexture &texture, int index) {
    const fs::path name = fs::canonical(file_).string() + '*' + std::to_string(index);
    return texture_once(scene_.textures, name,
                        [&] { return read_embedded(texture, name, in_mesh()); });
}

int MeshMaterials::load_file(const std::string &name) {
    if (name.starts_with('$')) {  // Assimp's, as "$texture_dummy.bmp", where the file names none
        return no_texture;
    }
    const std::optional<fs::path> found = find_companion(name, folders_);
    if (!found) {
        missing_.push_back(name);
        return no_texture;
    }
    return load_texture(scene_.textures, *found, in_mesh());
}

SourceLocation MeshMaterials::in_mesh() const {
    return {.file = to_string(where_) + ": texture of " + file_.string()};
}

void MeshMaterials::warn() const {
    const auto add = [&](const std::vector<std::string> &lines, const std::string &prefix) {
        if (!lines.empty()) {
            scene_.warnings.push_back(one_line(fmt::format(
                "{}{}{}; the material's colour is drawn instead", prefix, lines.front(),
                lines.size() > 1 ? fmt::format(" (and {} more)", lines.size() - 1) : "")));
        }
    };
    add(missing_, to_string(in_mesh()) + ": no file ");
    add(unreadable_, "");
}

}  // namespace stagelight
