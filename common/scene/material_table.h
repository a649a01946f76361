// SPDX-License-Identifier: MIT
// The [materials] of a scene file, and who uses them.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>

#include "scene/scene.h"
#include "scene/toml_reader.h"

namespace stagelight {

class MaterialTable {
public:
    // Appends every material of [materials] to the scene; `scene.file` is set.
    MaterialTable(Scene &scene, const TableReader &root);

    // The index of the material that a shape's table names, else of a plain white
    // diffuse one. Its texture is loaded when the first shape uses it.
    int of_shape(const TableReader &shape);
    // The same for a sphere, which nothing is cut out of.
    int of_sphere(const TableReader &sphere);
    // And for a plane, which has no coordinates for a texture either.
    int of_plane(const TableReader &plane);

private:
    struct Named {
        int index = 0;
        TableReader table;
    };

    const Named &named(const TableReader &shape) const;
    int textured(const Named &material);
    int plain_white();

    Scene *scene_;
    std::map<std::string, Named, std::less<>> materials_;
    int plain_white_ = -1;  // its index once a shape needs it
};

// The file that `key` names, on the asset path of the scene in `scene_file`.
std::filesystem::path asset_of(const TableReader &table, std::string_view key,
                               const std::filesystem::path &scene_file);

}  // namespace stagelight
