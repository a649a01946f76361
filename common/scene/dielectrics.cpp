// SPDX-License-Identifier: MIT
#include "scene/dielectrics.h"

#include <cstddef>

namespace stagelight {

bool is_dielectric(const Scene &scene, int material) {
    return scene.materials[static_cast<std::size_t>(material)].type == MaterialType::dielectric;
}

std::vector<std::vector<std::uint32_t>> dielectric_triangles(const Scene &scene) {
    std::vector<std::vector<std::uint32_t>> of_mesh(scene.meshes.size());
    for (std::uint32_t i = 0; i < scene.triangles.size(); ++i) {
        const Triangle &triangle = scene.triangles[i];
        if (is_dielectric(scene, triangle.material)) {
            of_mesh[static_cast<std::size_t>(triangle.mesh)].push_back(i);
        }
    }
    return of_mesh;
}

}  // namespace stagelight
