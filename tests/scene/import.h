// SPDX-License-Identifier: MIT
#pragma once

#include "scene/mesh_import.h"

namespace stagelight {

inline const SourceLocation mesh_entry{"scene.toml", 3, 1};

inline void import_mesh(Scene &scene, const std::filesystem::path &file, const Placement &placement,
                        int material, const SourceLocation &where) {
    MeshImporter(scene).add(file, placement, material, where);
}

// A scene of this mesh alone.
inline Scene imported(const std::filesystem::path &file, const Placement &placement = {}) {
    Scene scene;
    import_mesh(scene, file, placement, material_of_file, mesh_entry);
    return scene;
}

}  // namespace stagelight
