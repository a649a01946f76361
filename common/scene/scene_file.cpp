// SPDX-License-Identifier: MIT
#include "scene/scene_file.h"

#include <array>
#include <cerrno>
#include <fstream>
#include <map>
#include <string>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "scene/contact.h"
#include "scene/errors.h"
#include "scene/large_triangles.h"
#include "scene/material_table.h"
#include "scene/mesh_import.h"
#include "scene/normalize.h"
#include "scene/orient.h"
#include "scene/progress.h"
#include "scene/toml_reader.h"
#include "scene/validators.h"

namespace stagelight {
namespace {

constexpr std::size_t largest_scene_file = 16 << 20;  // bytes

void read_settings(Scene &scene, const TableReader &root) {
    const TableReader image = root.table("image");
    image.refuse_unknown({"size"});
    if (image.has("size")) {
        const std::vector<double> size = image.numbers("size", 2, pixels);
        scene.width = static_cast<int>(size[0]);
        scene.height = static_cast<int>(size[1]);
    }
    const TableReader background = root.table("background");
    background.refuse_unknown({"color"});
    scene.background = background.vector("color", not_negative, scene.background);
    const TableReader trace = root.table("trace");
    trace.refuse_unknown({"max_depth"});
    scene.has_max_depth = trace.has("max_depth");
    scene.max_depth = static_cast<int>(trace.number("max_depth", bounces, scene.max_depth));
}

CameraDescription read_camera(const TableReader &table) {
    table.refuse_unknown({"position", "look_at", "up", "fov"});
    CameraDescription camera;
    camera.position = table.vector("position", any_number);
    camera.look_at = table.vector("look_at", any_number);
    camera.up = table.direction("up", camera.up);
    camera.fov = table.number("fov", field_of_view, camera.fov);
    const SourceLocation where = table.where("look_at");
    if (camera.look_at == camera.position) {
        throw UserError(fmt::format("{}: look_at is the camera's position, expected another point",
                                    to_string(where)));
    }
    // A smaller angle between them than this is lost in single precision.
    if (glm::length(glm::cross(normalize(camera.look_at - camera.position), camera.up)) < 1e-6) {
        throw UserError(fmt::format("{}: the camera looks along up, expected another look_at or up",
                                    to_string(where)));
    }
    return camera;
}

Light read_light(const TableReader &table) {
    table.refuse_unknown({"type", "position", "range", "direction", "color", "intensity"});
    const std::string type = table.choice("type", {"point", "directional"});
    table.refuse_unless({"point"}, type, "position");
    table.refuse_unless({"point"}, type, "range");
    table.refuse_unless({"directional"}, type, "direction");
    Light light;
    if (type == "point") {
        light.type = LightType::point;
        light.position = table.vector("position", any_number);
        light.range = table.number("range", positive, light.range);
    } else {
        light.type = LightType::directional;
        light.direction = table.direction("direction");
    }
    light.color = table.vector("color", not_negative, light.color);
    light.intensity = table.number("intensity", not_negative, light.intensity);
    light.where = table.where();
    return light;
}

Sphere read_sphere(const TableReader &table, MaterialTable &materials) {
    table.refuse_unknown({"center", "radius", "material"});
    return {.center = table.vector("center", any_number),
            .radius = table.number("radius", positive),
            .material = materials.of_sphere(table),
            .where = table.where()};
}

Plane read_plane(const TableReader &table, MaterialTable &materials) {
    table.refuse_unknown({"normal", "point", "material"});
    return {.normal = table.direction("normal"),
            .point = table.vector("point", any_number),
            .material = materials.of_plane(table),
            .where = table.where()};
}

// Reads [[meshes]] entries.
class MeshReader {
public:
    MeshReader(Scene &scene, MaterialTable &materials)
        : scene_file_(scene.file), materials_(materials), importer_(scene) {}

    void read(const TableReader &table) {
        table.refuse_unknown({"file", "position", "rotation", "scale", "material"});
        Placement placement;
        placement.position = table.vector("position", any_number, placement.position);
        placement.rotation = table.vector("rotation", any_number, placement.rotation);
        placement.scale = table.has_array("scale")
                              ? table.vector("scale", not_zero)
                              : glm::dvec3(table.number("scale", not_zero, 1.0));
        const int material = table.has("material") ? materials_.of_shape(table) : material_of_file;
        importer_.add(file_of(table), placement, material, table.where("file"));
    }

private:
    // To search the packages takes milliseconds, and a thousand entries may name one file.
    const std::filesystem::path &file_of(const TableReader &table) {
        const std::string name = table.text("file");
        const auto known = files_.find(name);
        return known == files_.end()
                   ? files_.emplace(name, asset_of(table, "file", scene_file_)).first->second
                   : known->second;
    }

    std::filesystem::path scene_file_;
    MaterialTable &materials_;
    MeshImporter importer_;
    std::map<std::string, std::filesystem::path> files_;  // by the name that entries have for it
};

Scene read_scene(const std::filesystem::path &file, const TableReader &root) {
    root.refuse_unknown({"image", "camera", "background", "trace", "materials", "spheres", "planes",
                         "meshes", "lights"});
    Scene scene;
    scene.file = file;
    read_settings(scene, root);
    scene.camera = read_camera(root.table("camera"));
    for (const TableReader &table : root.array_of_tables("lights")) {
        scene.lights.push_back(read_light(table));
    }
    MaterialTable materials(scene, root);
    for (const TableReader &table : root.array_of_tables("spheres")) {
        scene.spheres.push_back(read_sphere(table, materials));
    }
    for (const TableReader &table : root.array_of_tables("planes")) {
        scene.planes.push_back(read_plane(table, materials));
    }
    // Last: an import takes the longest, and appends materials of its own.
    const auto meshes = root.array_of_tables("meshes");
    Progress progress("loading the meshes of " + file.filename().string(), meshes.size());
    MeshReader reader(scene, materials);
    for (const TableReader &table : meshes) {
        reader.read(table);
        progress.step();
    }
    const std::vector<std::string> unclear = orient_dielectrics(scene);
    scene.warnings.insert(scene.warnings.end(), unclear.begin(), unclear.end());
    settle_contacts(scene);
    cut_large_triangles(scene);
    if (scene.materials.empty()) {
        scene.materials.emplace_back();  // a buffer can't be empty, not even for an empty scene
    }
    return scene;
}

std::string read_text(const std::filesystem::path &file) {
    const auto refuse = [&](std::string_view what) {
        throw UserError(fmt::format("{}: {}, expected a scene in TOML", file.string(), what));
    };
    std::error_code unimportant;  // opening it will tell
    if (std::filesystem::is_directory(file, unimportant)) {
        refuse("is a folder");
    }
    std::ifstream stream(file, std::ios::binary);
    if (!stream) {
        refuse("can't be opened: " + std::generic_category().message(errno));
    }
    std::string text;
    std::array<char, 1 << 14> block{};
    while (stream && text.size() <= largest_scene_file) {
        stream.read(block.data(), block.size());
        text.append(block.data(), static_cast<std::size_t>(stream.gcount()));
    }
    if (stream.bad()) {
        refuse("can't be read");
    }
    if (text.size() > largest_scene_file) {
        refuse("is larger than 16 MiB");
    }
    return text;
}

// toml++ goes one call deeper for each part of a dotted key, to the end of the stack.
void require_short_keys(const std::string &text, const std::filesystem::path &file) {
    constexpr int most_parts = 1000;
    unsigned line = 1;
    int parts = 1;  // of what may be a key
    for (const char c : text) {
        line += c == '\n' ? 1 : 0;
        if (c == '.') {
            ++parts;
        } else if (std::string_view("=[]{},#\n").find(c) != std::string_view::npos) {
            parts = 1;
        }
        if (parts > most_parts) {
            throw UserError(fmt::format("{}: a key of more than {} parts, expected a few",
                                        to_string({file.string(), line, 1}), most_parts));
        }
    }
}

}  // namespace

Scene load_scene(const std::filesystem::path &file) {
    const std::string text = read_text(file);
    require_short_keys(text, file);
    try {
        const toml::table root = toml::parse(text);
        return read_scene(file, TableReader(root, "the scene", {file.string(), 1, 1}));
    } catch (const toml::parse_error &error) {
        const toml::source_position at = error.source().begin;
        throw UserError(fmt::format("{}: {}", to_string({file.string(), at.line, at.column}),
                                    error.description()));
    }
}

}  // namespace stagelight
