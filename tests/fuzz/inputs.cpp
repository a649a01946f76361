// SPDX-License-Identifier: MIT
#include "fuzz/inputs.h"

#include <fstream>
#include <iterator>
#include <string>

#include "scene/errors.h"
#include "scene/mesh_import.h"
#include "scene/scene_file.h"
#include "scene/temporary_folder.h"
#include "scene/texture_set.h"

namespace stagelight::fuzz {
namespace {

// Calls `read` with a file of these bytes.
template <typename Read>
void try_file(const std::string &name, std::string_view bytes, const Read &read) {
    const TemporaryFolder folder;
    try {
        read(folder.write(name, bytes));
    } catch (const UserError &) {
    } catch (const MachineError &) {
    }
}

constexpr std::string_view wears_materials =
    "mtllib mesh.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n"
    "usemtl a\nf 1/1 2/2 3/3\nusemtl b\nf 1/1 2/2 3/3\n";

}  // namespace

void read_scene(std::string_view bytes) {
    try_file("scene.toml", bytes, load_scene);
}

void read_mesh(std::string_view bytes) {
    if (!bytes.empty()) {
        const auto format = static_cast<unsigned char>(bytes.front()) % std::size(mesh_formats);
        try_file("mesh." + std::string(mesh_formats[format]), bytes.substr(1),
                 [](std::filesystem::path file) {
                     if (file.extension() == ".mtl") {
                         file.replace_extension(".obj");
                         std::ofstream(file) << wears_materials;
                     }
                     Scene scene;
                     MeshImporter(scene).add(file, {}, material_of_file, {.file = "scene.toml"});
                 });
    }
}

void read_texture(std::string_view bytes) {
    try_file("picture", bytes, [](const std::filesystem::path &file) {
        std::vector<Texture> textures;
        load_texture(textures, file, {.file = "scene.toml"});
    });
}

}  // namespace stagelight::fuzz
