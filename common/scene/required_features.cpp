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
    void add(const char *what, int first_stage, const SourceLocation &where,
             bool is_optional = false) {
        const auto noted = std::ranges::find(features_, what, &RequiredFeature::what);
        if (noted == features_.end()) {
            features_.push_back({what, first_stage, where, is_optional});
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
        const Texture &texture = scene.textures[static_cast<std::size_t>(material.texture)];
        notes.add("texture", 6, texture.where);
        if (texture.wrap_u != Wrap::repeat || texture.wrap_v != Wrap::repeat) {
            notes.add("clamped or mirrored texture", 6, texture.where);
        }
    }
    if (has_cutout(material)) {
        notes.add("cut-out", 6, material.where);
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
        if (std::ranges::any_of(triangle.vertices, [&](std::uint32_t vertex) {
                return scene.vertices[vertex].color != glm::dvec3(1);
            })) {
            notes.add("mesh with colours of vertices", 6,
                      scene.meshes[static_cast<std::size_t>(triangle.mesh)].where, true);
        }
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
    std::vector<RequiredFeature> features = required_features(scene);
    std::erase_if(features, [](const RequiredFeature &feature) { return feature.is_optional; });
    if (features.empty() || features.back().first_stage <= stage) {
        return;
    }
    const RequiredFeature &last = features.back();
    throw UserError(fmt::format(
        "{}: a {}: unsupported by {}; {} is the first stage that can draw it",
        to_string(last.where), last.what, stage_name(stage), stage_name(last.first_stage)));
}

std::vector<std::string> take_out_unsupported(Scene &scene, int stage) {
    std::vector<std::string> lines;
    for (const RequiredFeature &feature : required_features(scene)) {
        if (feature.is_optional && feature.first_stage > stage) {
            lines.push_back(
                fmt::format("{}: a {}: drawn without them by {}; {} is the first stage that "
                            "has them",
                            to_string(feature.where), feature.what, stage_name(stage),
                            stage_name(feature.first_stage)));
            for (Vertex &vertex : scene.vertices) {
                vertex.color = glm::dvec3(1);  // the only one that is optional
            }
        }
    }
    return lines;
}

}  // namespace stagelight
