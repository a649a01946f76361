// SPDX-License-Identifier: MIT
#include "scene/required_features.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "scene/errors.h"
#include "scene/stages.h"

namespace stagelight {
namespace {

class Notes {
public:
    void add(const char *what, int first_stage, const SourceLocation &where) {
        const auto noted = std::ranges::find(features_, what, &RequiredFeature::what);
        if (noted == features_.end()) {
            features_.push_back({what, first_stage, where});
        } else if (std::tie(where.line, where.column)
                   < std::tie(noted->where.line, noted->where.column)) {
            noted->where = where;
        }
    }

    std::vector<RequiredFeature> in_order() && {
        std::ranges::stable_sort(features_, {}, &RequiredFeature::first_stage);
        return std::move(features_);
    }

private:
    std::vector<RequiredFeature> features_;
};

void add_type(Notes &notes, const Material &material) {
    switch (material.type) {
    case MaterialType::diffuse:
        if (material.where.line > 0) {  // else it is that of shapes that name none
            notes.add("diffuse material", 2, material.where);
        }
        return;
    case MaterialType::mirror:
        return notes.add("mirror material", 3, material.where);
    case MaterialType::glossy:
        return notes.add("glossy material", 3, material.where);
    case MaterialType::dielectric:
        return notes.add("dielectric material", 4, material.where);
    }
}

void add_material(Notes &notes, const Scene &scene, const Material &material) {
    add_type(notes, material);
    if (material.texture != no_texture) {
        notes.add("texture", 6, scene.textures[static_cast<std::size_t>(material.texture)].where);
    }
}

void add_shapes(Notes &notes, const Scene &scene, std::vector<bool> &used) {
    const auto use = [&](int material) { used[static_cast<std::size_t>(material)] = true; };
    for (const Sphere &sphere : scene.spheres) {
        notes.add("sphere", 1, sphere.where);
        use(sphere.material);
    }
    for (const Plane &plane : scene.planes) {
        notes.add("plane", 1, plane.where);
        use(plane.material);
    }
    for (const Mesh &mesh : scene.meshes) {
        notes.add("mesh", 5, mesh.where);
    }
    for (const Triangle &triangle : scene.triangles) {
        use(triangle.material);
        if (scene.materials[static_cast<std::size_t>(triangle.material)].type
            == MaterialType::dielectric) {
            notes.add("dielectric mesh", 11,
                      scene.meshes[static_cast<std::size_t>(triangle.mesh)].where);
        }
    }
}

}  // namespace

std::vector<RequiredFeature> required_features(const Scene &scene) {
    Notes notes;
    std::vector<bool> used(scene.materials.size());
    add_shapes(notes, scene, used);
    for (std::size_t i = 0; i < used.size(); ++i) {
        if (used[i]) {
            add_material(notes, scene, scene.materials[i]);
        }
    }
    for (const Light &light : scene.lights) {
        notes.add("light", 2, light.where);
    }
    return std::move(notes).in_order();
}

void require_supported(const Scene &scene, int stage) {
    const std::vector<RequiredFeature> features = required_features(scene);
    if (features.empty() || features.back().first_stage <= stage) {
        return;
    }
    const RequiredFeature &last = features.back();
    throw UserError(fmt::format(
        "{}: a {}: unsupported by {}; {} is the first stage that can draw it",
        to_string(last.where), last.what, stage_name(stage), stage_name(last.first_stage)));
}

}  // namespace stagelight
