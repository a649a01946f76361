// SPDX-License-Identifier: MIT
#include "scene/lessons.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "scene/errors.h"

namespace stagelight {
namespace {

class Notes {
public:
    void add(const char *what, int first_stage, const SourceLocation &where) {
        const auto noted = std::find_if(lessons_.begin(), lessons_.end(),
                                        [&](const Lesson &lesson) { return lesson.what == what; });
        if (noted == lessons_.end()) {
            lessons_.push_back({what, first_stage, where});
        } else if (std::tie(where.line, where.column)
                   < std::tie(noted->where.line, noted->where.column)) {
            noted->where = where;
        }
    }

    std::vector<Lesson> in_order() && {
        std::stable_sort(lessons_.begin(), lessons_.end(), [](const Lesson &a, const Lesson &b) {
            return a.first_stage < b.first_stage;
        });
        return std::move(lessons_);
    }

private:
    std::vector<Lesson> lessons_;
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

std::vector<Lesson> lessons_of(const Scene &scene) {
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

void require_learnt(const Scene &scene, int stage) {
    const std::vector<Lesson> lessons = lessons_of(scene);
    if (lessons.empty() || lessons.back().first_stage <= stage) {
        return;
    }
    const Lesson &last = lessons.back();
    throw UserError(fmt::format(
        "{}: a {}: {} has not learnt that yet; {} is the first stage that can draw it",
        to_string(last.where), last.what, stage_name(stage), stage_name(last.first_stage)));
}

}  // namespace stagelight
