// SPDX-License-Identifier: MIT
#include "scene/mesh_materials.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include <assimp/GltfMaterial.h>
#include <assimp/material.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <glm/matrix.hpp>

#include "scene/companion_file.h"
#include "scene/errors.h"
#include "scene/picture.h"
#include "scene/texture_alpha.h"

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

enum class AlphaMode { opaque, mask, blend };

// What is less than `cutoff` is not there.
struct Alpha {
    AlphaMode mode = AlphaMode::blend;
    double opacity = 1;         // multiplies the texture's
    double cutoff = 0.5 / 255;  // half of the least step that a texture has
};

// glTF says what alpha stands for; in other formats it blends.
Alpha alpha_of(const aiMaterial &material) {
    Alpha alpha;
    float opacity = 1, cutoff = 0.5F;
    if (material.Get(AI_MATKEY_OPACITY, opacity) == aiReturn_SUCCESS && std::isfinite(opacity)) {
        alpha.opacity = opacity;
    }
    aiString mode;
    material.Get(AI_MATKEY_GLTF_ALPHAMODE, mode);
    if (mode == aiString("OPAQUE")) {
        alpha.mode = AlphaMode::opaque;
    } else if (mode == aiString("MASK")) {
        alpha.mode = AlphaMode::mask;
        material.Get(AI_MATKEY_GLTF_ALPHACUTOFF, cutoff);
        alpha.cutoff = cutoff;
    }
    return alpha;
}

std::string name_of(const aiMaterial &material) {
    aiString name;
    material.Get(AI_MATKEY_NAME, name);
    return name.C_Str();
}

// The set of texture coordinates that its texture lies by.
unsigned coordinates_of(const aiMaterial &material) {
    for (const aiTextureType type :
         {aiTextureType_DIFFUSE, aiTextureType_BASE_COLOR, aiTextureType_OPACITY}) {
        aiString name;
        unsigned set = 0;
        if (material.GetTexture(type, 0, &name, nullptr, &set) == aiReturn_SUCCESS) {
            return set;
        }
    }
    return 0;
}

Wrap wrap_of(const aiMaterial &material, const char *key, unsigned type, unsigned index) {
    int mode = aiTextureMapMode_Wrap;
    material.Get(key, type, index, mode);
    switch (mode) {
    case aiTextureMapMode_Clamp:
    case aiTextureMapMode_Decal:
        return Wrap::clamp;
    case aiTextureMapMode_Mirror:
        return Wrap::mirror;
    default:
        return Wrap::repeat;
    }
}

Wraps wraps_of(const aiMaterial &material, aiTextureType type) {
    return {wrap_of(material, AI_MATKEY_MAPPINGMODE_U(type, 0)),
            wrap_of(material, AI_MATKEY_MAPPINGMODE_V(type, 0))};
}

// Assimp scales, turns about the middle of the picture and moves, v going up.
glm::dmat3 transform_of(const aiMaterial &material, aiTextureType type) {
    aiUVTransform transform;
    if (material.Get(AI_MATKEY_UVTRANSFORM(type, 0), transform) != aiReturn_SUCCESS) {
        return glm::dmat3(1);
    }
    const double c = std::cos(double{transform.mRotation});
    const double s = std::sin(double{transform.mRotation});
    const glm::dmat3 scale(transform.mScaling.x, 0, 0, 0, transform.mScaling.y, 0, 0, 0, 1);
    const glm::dmat3 to_middle(1, 0, 0, 0, 1, 0, -0.5, -0.5, 1);
    const glm::dmat3 turn(c, s, 0, -s, c, 0, 0, 0, 1);
    const glm::dmat3 move(1, 0, 0, 0, 1, 0, 0.5 + transform.mTranslation.x,
                          0.5 + transform.mTranslation.y, 1);
    const glm::dmat3 flip(1, 0, 0, 0, -1, 0, 0, 1, 1);
    const glm::dmat3 all = flip * move * turn * to_middle * scale * flip;
    const double determinant = glm::determinant(all);
    return std::isfinite(determinant) && determinant != 0 ? all : glm::dmat3(1);
}

// Assimp's reader of AMF gives vertices without a colour one that is 0 in all four channels.
bool has_colors(const aiMesh &mesh) {
    return mesh.HasVertexColors(0)
           && std::any_of(mesh.mColors[0], mesh.mColors[0] + mesh.mNumVertices,
                          [](const aiColor4D &color) { return color != aiColor4D(); });
}

}  // namespace

MeshMaterials::MeshMaterials(Scene &scene, const MeshFile &meshes, fs::path file,
                             SourceLocation where)
    : scene_(scene), meshes_(meshes.scene()), notes_(meshes.notes()), file_(std::move(file)),
      folders_(meshes.files().folders), where_(std::move(where)),
      known_materials_(scene.materials.size()) {}

Look MeshMaterials::look_of(const aiMesh &mesh) {
    const aiMaterial &material = *meshes_.mMaterials[mesh.mMaterialIndex];
    unsigned coordinates = coordinates_of(material);
    coordinates = mesh.HasTextureCoords(coordinates) ? coordinates : 0;
    const bool is_colored = has_colors(mesh);
    const std::tuple key{mesh.mMaterialIndex, coordinates, mesh.HasTextureCoords(coordinates),
                         is_colored};
    if (const auto known = looks_.find(key); known != looks_.end()) {
        return known->second;
    }
    Look look{
        .coordinates = coordinates, .has_colors = is_colored, .are_colors_linear = notes_.is_gltf};
    add(material, mesh.HasTextureCoords(coordinates), look);
    looks_.emplace(key, look);
    return look;
}

void MeshMaterials::add(const aiMaterial &material, bool with_texture, Look &look) {
    look.is_seen = is_seen(material);
    if (!look.is_seen) {
        return;
    }
    Material added;
    added.where = where_;
    added.color = color_of(material);
    if (look.has_colors && name_of(material) == AI_DEFAULT_MATERIAL_NAME) {
        added.color = glm::dvec3(1);  // Assimp's grey for a file without materials
    }
    if (with_texture) {
        added.texture = texture_of(material, look);
    } else if (material.GetTextureCount(aiTextureType_DIFFUSE) > 0) {
        warnings_.insert("has textures on meshes without texture coordinates, which aren't drawn");
    }
    set_alpha(material, added);
    note_what_is_lost(material);
    look.material = static_cast<int>(scene_.materials.size());
    scene_.materials.push_back(added);
}

int MeshMaterials::texture_of(const aiMaterial &material, Look &look) {
    const std::size_t known_textures = scene_.textures.size();
    int texture = no_texture;
    aiTextureType used = aiTextureType_DIFFUSE;
    aiString name;
    for (const aiTextureType type : {aiTextureType_DIFFUSE, aiTextureType_BASE_COLOR}) {
        aiString found;
        if (texture == no_texture && material.GetTexture(type, 0, &found) == aiReturn_SUCCESS
            && found.length > 0) {
            texture = load(found, wraps_of(material, type));
            used = type;
            name = found;
        }
    }
    const auto notes = notes_.materials.find(name_of(material));
    look.texture_transform = notes == notes_.materials.end() ? transform_of(material, used)
                                                             : notes->second.texture_transform;
    aiString mask;
    if (material.GetTexture(aiTextureType_OPACITY, 0, &mask) == aiReturn_SUCCESS && mask.length > 0
        && mask != name) {
        used = texture == no_texture ? aiTextureType_OPACITY : used;
        texture = with_mask(texture, name, mask, wraps_of(material, used), known_textures);
    }
    return texture;
}

// Without a texture of colours, the mask's is white. Those from `known_textures` on are of use no
// more once the two are put together.
int MeshMaterials::with_mask(int texture, const aiString &color, const aiString &mask, Wraps wraps,
                             std::size_t known_textures) {
    std::vector<Texture> &textures = scene_.textures;
    Texture masked;
    fs::path &file = masked_[{color.C_Str(), mask.C_Str()}];
    if (file.empty()) {
        const int loaded = load(mask, wraps);
        if (loaded == no_texture) {
            return texture;
        }
        const Texture of_alpha = textures[static_cast<std::size_t>(loaded)];
        Texture of_color = of_alpha;
        of_color.texels.assign(of_color.texels.size(), 255);
        of_color.file = "white";
        if (texture != no_texture) {
            of_color = textures[static_cast<std::size_t>(texture)];
        }
        masked = with_alpha(of_color, of_alpha);
        file = of_color.file.string() + " with the alpha of " + of_alpha.file.string();
        masked.file = file;
    }
    textures.resize(known_textures);
    return texture_once(
        textures, file, [&] { return masked; }, wraps);
}

bool MeshMaterials::is_seen(const aiMaterial &material) {
    const Alpha alpha = alpha_of(material);
    if (notes_.is_collada && alpha.opacity <= 0) {
        warnings_.insert(
            "says of a material that it can't be seen, as many exporters of Collada do "
            "by mistake: it is drawn solid");
        return true;
    }
    return alpha.mode == AlphaMode::opaque || alpha.opacity >= alpha.cutoff;
}

// Cut-outs are for textures that need them.
void MeshMaterials::set_alpha(const aiMaterial &material, Material &added) {
    const Alpha alpha = alpha_of(material);
    if (alpha.mode == AlphaMode::opaque) {
        return;
    }
    const AlphaRange range =
        added.texture == no_texture
            ? AlphaRange{}
            : alpha_range(scene_.textures[static_cast<std::size_t>(added.texture)]);
    const double cutoff =
        alpha.mode == AlphaMode::mask ? alpha.cutoff / alpha.opacity : alpha.cutoff;
    if (range.least < 255 * cutoff) {
        added.alpha_cutoff = cutoff;
    }
    if (alpha.mode == AlphaMode::blend
        && (range.has_partial || (alpha.opacity < 1 && alpha.opacity > 0))) {
        warnings_.insert("is partly transparent, which isn't blended here: what is there at all is "
                         "drawn solid");
    }
}

void MeshMaterials::note_what_is_lost(const aiMaterial &material) {
    constexpr std::array<std::pair<aiTextureType, const char *>, 11> maps{
        {{aiTextureType_NORMALS, "a normal map"},
         {aiTextureType_HEIGHT, "a bump map"},
         {aiTextureType_DISPLACEMENT, "a displacement map"},
         {aiTextureType_EMISSIVE, "a map of its own light"},
         {aiTextureType_EMISSION_COLOR, "a map of its own light"},
         {aiTextureType_LIGHTMAP, "an occlusion map"},
         {aiTextureType_AMBIENT_OCCLUSION, "an occlusion map"},
         {aiTextureType_REFLECTION, "a map of reflections"},
         {aiTextureType_SPECULAR, "a map of reflections"},
         {aiTextureType_METALNESS, "a map of metal and roughness"},
         {aiTextureType_DIFFUSE_ROUGHNESS, "a map of metal and roughness"}}};
    for (const auto &[type, what] : maps) {
        if (material.GetTextureCount(type) > 0) {
            not_drawn_.insert(what);
        }
    }
    if (material.GetTextureCount(aiTextureType_DIFFUSE) > 1) {
        not_drawn_.insert("a second texture");
    }
    const auto notes = notes_.materials.find(name_of(material));
    if (notes != notes_.materials.end()) {
        not_drawn_.insert(notes->second.not_drawn.begin(), notes->second.not_drawn.end());
    }
}

void MeshMaterials::warn() {
    warn_of_pictures();
    const auto added = std::span(scene_.materials).subspan(known_materials_);
    if (!added.empty() && std::ranges::all_of(added, [](const Material &material) {
            return material.color == glm::dvec3(0) && material.texture == no_texture;
        })) {
        warnings_.insert("has materials that are black and nothing else");
    }
    if (!not_drawn_.empty()) {
        warnings_.insert(
            fmt::format("its materials have what isn't drawn: {}", fmt::join(not_drawn_, ", ")));
    }
    warnings_.insert(notes_.warnings.begin(), notes_.warnings.end());
    for (const std::string &warning : warnings_) {
        scene_.warnings.push_back(
            fmt::format("{}: {}: {}", to_string(where_), file_.string(), warning));
    }
    warnings_.clear();
}

int MeshMaterials::load(const aiString &texture, Wraps wraps) {
    const std::string name = texture.C_Str();
    if (failed_.contains(name)) {
        return no_texture;
    }
    int index = no_texture;
    try {
        // No structured binding: Clang 14 lets no lambda have one.
        const std::pair found = meshes_.GetEmbeddedTextureAndIndex(name.c_str());
        index =
            found.first ? load_embedded(*found.first, found.second, wraps) : load_file(name, wraps);
    } catch (const UserError &error) {
        unreadable_.emplace_back(error.what());
    }
    if (index == no_texture) {
        failed_.insert(name);
    }
    return index;
}

int MeshMaterials::load_embedded(const aiTexture &texture, int index, Wraps wraps) {
    const fs::path name = fs::canonical(file_).string() + '*' + std::to_string(index);
    return texture_once(
        scene_.textures, name, [&] { return read_embedded(texture, name, in_mesh()); }, wraps);
}

int MeshMaterials::load_file(const std::string &name, Wraps wraps) {
    if (name.starts_with('$')) {  // Assimp's, as "$texture_dummy.bmp", where the file names none
        return no_texture;
    }
    const std::optional<fs::path> found = find_companion(name, folders_);
    if (!found) {
        missing_.push_back(name);
        return no_texture;
    }
    return load_texture(scene_.textures, *found, in_mesh(), wraps);
}

SourceLocation MeshMaterials::in_mesh() const {
    return {.file = to_string(where_) + ": texture of " + file_.string()};
}

void MeshMaterials::warn_of_pictures() const {
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
