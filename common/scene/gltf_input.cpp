// SPDX-License-Identifier: MIT
#include "scene/gltf_input.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "scene/gltf_accessors.h"

namespace stagelight {
namespace {

using nlohmann::json;

constexpr std::string_view glb_magic = "glTF";
constexpr std::size_t glb_header = 12, chunk_header = 8;

std::uint32_t word_at(std::string_view bytes, std::size_t at) {
    std::uint32_t word = 0;
    std::memcpy(&word, bytes.data() + at, sizeof word);
    return word;
}

void put_word(std::string &bytes, std::size_t word) {
    const auto value = static_cast<std::uint32_t>(word);
    bytes.append(reinterpret_cast<const char *>(&value), sizeof value);
}

// A .glb's JSON and its buffer; or the whole file, which is JSON alone.
struct Chunks {
    std::string_view json{}, binary{};
    bool is_glb = false;
};

Chunks chunks_of(std::string_view bytes) {
    if (!bytes.starts_with(glb_magic)) {
        return {.json = bytes};
    }
    Chunks chunks{.is_glb = true};
    std::string_view rest = bytes.substr(std::min(glb_header, bytes.size()));
    for (std::string_view *chunk : {&chunks.json, &chunks.binary}) {
        if (rest.size() >= chunk_header) {
            const std::size_t size = std::min<std::size_t>(word_at(rest, 0), rest.size() - 8);
            *chunk = rest.substr(chunk_header, size);
            rest.remove_prefix(chunk_header + size);
        }
    }
    return chunks;
}

// glTF 2.0, section 4: chunks are padded to whole words, the JSON's with spaces.
std::string glb_of(std::string json_text, std::string_view binary) {
    json_text.resize((json_text.size() + 3) / 4 * 4, ' ');
    std::string padded(binary);
    padded.resize((padded.size() + 3) / 4 * 4, '\0');
    std::string bytes(glb_magic);
    put_word(bytes, 2);
    put_word(bytes, glb_header + chunk_header + json_text.size()
                        + (binary.empty() ? 0 : chunk_header + padded.size()));
    put_word(bytes, json_text.size());
    bytes += "JSON" + json_text;
    if (!binary.empty()) {
        put_word(bytes, padded.size());
        bytes += std::string("BIN\0", 4) + padded;
    }
    return bytes;
}

// What is done about an extension that a file requires and Assimp's reader has not got.
struct Remedy {
    std::string_view extension;
    std::string_view what;
};

constexpr std::array<Remedy, 3> refused{
    {{"EXT_meshopt_compression", "gltfpack without -c, or gltf-transform copy, writes it anew"},
     {"KHR_meshopt_compression", "gltf-transform copy writes it anew"},
     {"KHR_gaussian_splatting", "it has no surface"}}};

// Looks alone: the shape is right without them.
bool is_look(std::string_view extension) {
    return extension.starts_with("KHR_materials_") || extension.starts_with("KHR_texture_")
           || extension.starts_with("EXT_texture_") || extension.starts_with("KHR_lights_")
           || extension.starts_with("EXT_lights_") || extension.starts_with("MSFT_texture_")
           || extension.starts_with("ADOBE_materials_") || extension == "KHR_technique_webgl";
}

constexpr std::array<std::string_view, 8> drawn_extensions{
    "KHR_draco_mesh_compression",  // if Assimp was built with it; else it says so

    "KHR_mesh_quantization",      "KHR_texture_transform", "EXT_mesh_gpu_instancing",
    "EXT_texture_webp",           "KHR_materials_unlit",   "KHR_materials_pbrSpecularGlossiness",
    "KHR_animation_pointer"};

json &list_of(json &document, const char *name) {
    json &list = document[name];
    if (!list.is_array()) {
        list = json::array();
    }
    return list;
}

void check_required(const json &document, MeshNotes &notes) {
    for (const json &required : document.value("extensionsRequired", json::array())) {
        const std::string extension = required;
        if (std::ranges::find(drawn_extensions, extension) != drawn_extensions.end()) {
            continue;
        }
        const auto *const remedy = std::ranges::find(refused, extension, &Remedy::extension);
        if (remedy != refused.end() || !is_look(extension)) {
            throw std::invalid_argument(
                fmt::format("requires {}, which isn't read here, expected a file without it{}{}",
                            extension, remedy != refused.end() ? ": " : "",
                            remedy != refused.end() ? remedy->what : std::string_view()));
        }
        notes.warnings.insert(fmt::format("requires {}, which isn't drawn", extension));
    }
}

template <typename Visit> void for_each_attribute(json &document, const Visit &visit) {
    const json::json_pointer draco("/extensions/KHR_draco_mesh_compression");
    for (json &mesh : list_of(document, "meshes")) {
        for (json &primitive : mesh.at("primitives")) {
            if (primitive.contains(draco)) {
                continue;  // whose decoder makes the numbers
            }
            visit(primitive.at("attributes"));
            for (json &target : list_of(primitive, "targets")) {
                visit(target);
            }
            if (primitive["targets"].empty()) {
                primitive.erase("targets");
            }
        }
    }
}

void make_floats(json &document, GltfAccessors &accessors) {
    for_each_attribute(document, [&](json &attributes) {
        for (const auto &[name, accessor] : attributes.items()) {
            if (name == "POSITION" || name == "NORMAL" || name == "TANGENT"
                || name.starts_with("TEXCOORD_") || name.starts_with("WEIGHTS_")) {
                accessors.make_float(accessor.get<std::size_t>());
            }
        }
    });
}

// Vertices have colours here, and no alpha.
void note_transparent_vertices(const json &document, GltfAccessors &accessors, MeshNotes &notes) {
    for (const json &mesh : document.at("meshes")) {
        for (const json &primitive : mesh.at("primitives")) {
            const json &attributes = primitive.at("attributes");
            if (!attributes.contains("COLOR_0") || !primitive.contains("material")
                || document.at("materials")
                           .at(primitive.at("material").get<std::size_t>())
                           .value("alphaMode", "OPAQUE")
                       == "OPAQUE") {
                continue;
            }
            const auto accessor = attributes.at("COLOR_0").get<std::size_t>();
            const std::vector<float> colors = accessors.floats(accessor);
            if (document.at("accessors").at(accessor).at("type") == "VEC4") {
                for (std::size_t i = 3; i < colors.size(); i += 4) {
                    if (colors[i] < 1) {
                        notes.warnings.insert("has transparent vertices, which are drawn solid");
                    }
                }
            }
        }
    }
}

// Joints are found by their node's name. A node without one, or with another's, would get none.
void name_nodes_apart(json &document) {
    std::size_t number = 0;
    for (json &node : list_of(document, "nodes")) {
        node["name"] = fmt::format("node {}", number++);
    }
}

void place_instances(json &document, GltfAccessors &accessors) {
    const std::size_t count = list_of(document, "nodes").size();
    for (std::size_t i = 0; i < count; ++i) {
        const json node = document["nodes"][i];
        const json::json_pointer at("/extensions/EXT_mesh_gpu_instancing/attributes");
        if (!node.contains(at) || !node.contains("mesh")) {
            continue;
        }
        struct Part {
            const char *attribute, *property;
            std::size_t components;
            std::vector<float> values;
        };
        std::array<Part, 3> parts{{{"TRANSLATION", "translation", 3, {}},
                                   {"ROTATION", "rotation", 4, {}},
                                   {"SCALE", "scale", 3, {}}}};
        std::size_t instances = 0;
        for (Part &part : parts) {
            if (node.at(at).contains(part.attribute)) {
                part.values = accessors.floats(node.at(at).at(part.attribute).get<std::size_t>());
                instances = std::max(instances, part.values.size() / part.components);
            }
        }
        json children = node.value("children", json::array());
        for (std::size_t instance = 0; instance < instances; ++instance) {
            json child{{"mesh", node.at("mesh")}};
            for (const Part &part : parts) {
                if ((instance + 1) * part.components <= part.values.size()) {
                    const auto first = part.values.begin()
                                       + static_cast<std::ptrdiff_t>(instance * part.components);
                    child[part.property] = std::vector<float>(
                        first, first + static_cast<std::ptrdiff_t>(part.components));
                }
            }
            document["nodes"].push_back(std::move(child));
            children.push_back(document["nodes"].size() - 1);
        }
        json &parent = document["nodes"][i];
        parent.erase("mesh");
        parent.erase("extensions");
        parent["children"] = std::move(children);
    }
}

// Assimp keeps joints, and how far each shape is taken on, with the mesh, where a mesh may be used
// with several.
void part_meshes(json &document) {
    std::map<std::size_t, std::string> first_use;
    std::map<std::pair<std::size_t, std::string>, std::size_t> copies;
    for (json &node : list_of(document, "nodes")) {
        if (!node.contains("mesh")) {
            continue;
        }
        auto mesh = node.at("mesh").get<std::size_t>();
        const std::string use =
            node.value("skin", json()).dump() + node.value("weights", json()).dump();
        if (first_use.try_emplace(mesh, use).first->second != use) {
            const auto [copy, is_new] =
                copies.try_emplace({mesh, use}, list_of(document, "meshes").size());
            if (is_new) {
                json again = document["meshes"].at(mesh);
                document["meshes"].push_back(std::move(again));
            }
            mesh = copy->second;
            node["mesh"] = mesh;
        }
        if (node.contains("weights")) {
            document["meshes"].at(mesh)["weights"] = node.at("weights");
        }
    }
}

void complete_skins(json &document, GltfAccessors &accessors) {
    for (json &skin : list_of(document, "skins")) {
        if (!skin.contains("inverseBindMatrices")) {  // then they are the identity
            std::vector<float> matrices;
            for (std::size_t joint = 0; joint < skin.at("joints").size(); ++joint) {
                for (int i = 0; i < 16; ++i) {
                    matrices.push_back(i % 5 == 0 ? 1.0F : 0.0F);
                }
            }
            skin["inverseBindMatrices"] = accessors.add(matrices, "MAT4");
        }
    }
}

// KHR_texture_transform: translation · rotation · scale, the rotation counter-clockwise to one who
// looks at the picture, v going down.
glm::dmat3 transform_of(const json &extension) {
    const std::array<double, 2> offset = extension.value("offset", std::array{0.0, 0.0});
    const std::array<double, 2> scale = extension.value("scale", std::array{1.0, 1.0});
    const double rotation = extension.value("rotation", 0.0);
    const double c = std::cos(rotation), s = std::sin(rotation);
    return {c * scale[0], -s * scale[0], 0,  //
            s * scale[1], c * scale[1],  0,  //
            offset[0],    offset[1],     1};
}

void take_transform(json &info, glm::dmat3 &transform) {
    const json::json_pointer at("/extensions/KHR_texture_transform");
    if (info.contains(at)) {
        const json extension = info.at(at);
        transform = transform_of(extension);
        if (extension.contains("texCoord")) {
            info["texCoord"] = extension.at("texCoord");
        }
        info.at("extensions").erase("KHR_texture_transform");
    }
}

void note_materials(json &document, MeshNotes &notes) {
    constexpr std::array<std::pair<const char *, const char *>, 4> maps{
        {{"/normalTexture", "a normal map"},
         {"/emissiveTexture", "a map of its own light"},
         {"/occlusionTexture", "an occlusion map"},
         {"/pbrMetallicRoughness/metallicRoughnessTexture", "a map of metal and roughness"}}};
    constexpr std::array<const char *, 2> color_maps{
        "/pbrMetallicRoughness/baseColorTexture",
        "/extensions/KHR_materials_pbrSpecularGlossiness/diffuseTexture"};
    std::size_t number = 0;
    for (json &material : list_of(document, "materials")) {
        const std::string name = fmt::format("material {}", number++);
        material["name"] = name;
        MaterialNotes &of_material = notes.materials[name];
        for (const char *map : color_maps) {
            if (const json::json_pointer at(map); material.contains(at)) {
                take_transform(material.at(at), of_material.texture_transform);
            }
        }
        for (const auto &[map, what] : maps) {
            if (material.contains(json::json_pointer(map))) {
                of_material.not_drawn.insert(what);
            }
        }
        const json extensions = material.value("extensions", json::object());
        for (const auto &[extension, value] : extensions.items()) {
            if (std::ranges::find(drawn_extensions, extension) == drawn_extensions.end()) {
                of_material.not_drawn.insert(extension);
            }
        }
    }
}

void take_pictures(json &document) {
    const json::json_pointer webp("/extensions/EXT_texture_webp/source");
    for (json &texture : list_of(document, "textures")) {
        if (texture.contains(webp)) {
            texture["source"] = texture.at(webp);
        }
    }
}

bool has_textures_unread(const json &document) {
    return std::ranges::any_of(document.value("textures", json::array()),
                               [](const json &texture) { return !texture.contains("source"); });
}

void note_animations(json &document, MeshNotes &notes) {
    if (!list_of(document, "animations").empty()) {
        notes.warnings.insert("its animation isn't drawn, but the pose that it rests in");
    }
    document.erase("animations");
}

void drop_empty_lists(json &document) {
    for (const char *name : {"meshes", "nodes", "skins", "materials", "textures"}) {
        if (document[name].empty()) {
            document.erase(name);
        }
    }
}

std::optional<GltfInput> prepared(const Chunks &chunks, const ReadBeside &read_beside,
                                  MeshNotes &notes) {
    json document = json::parse(chunks.json);
    if (!document.at("asset").at("version").get<std::string>().starts_with("2")) {
        return std::nullopt;
    }
    check_required(document, notes);
    GltfAccessors accessors(document, chunks.binary, read_beside);
    note_animations(document, notes);
    make_floats(document, accessors);
    note_transparent_vertices(document, accessors, notes);
    place_instances(document, accessors);
    name_nodes_apart(document);
    part_meshes(document);
    complete_skins(document, accessors);
    take_pictures(document);
    if (has_textures_unread(document)) {
        notes.warnings.insert("has textures in a format that isn't read (KTX2 or DDS)");
    }
    note_materials(document, notes);
    drop_empty_lists(document);
    GltfInput input;
    input.converted = accessors.finish();
    const std::string text = document.dump(-1, ' ', false, json::error_handler_t::replace);
    input.bytes = chunks.is_glb ? glb_of(text, chunks.binary) : text;
    return input;
}

}  // namespace

std::optional<GltfInput> prepared_gltf(std::string_view bytes, const ReadBeside &read_beside,
                                       MeshNotes &notes) {
    try {
        return prepared(chunks_of(bytes), read_beside, notes);
    } catch (const json::exception &) {
    } catch (const std::out_of_range &) {
    }
    return std::nullopt;
}

}  // namespace stagelight
