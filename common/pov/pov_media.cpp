// SPDX-License-Identifier: MIT
#include "pov/pov_media.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "pov/pov_materials.h"
#include "scene/errors.h"

namespace stagelight::pov {
namespace {

void require_one_material_each(const Scene &scene, const Bodies &bodies) {
    for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
        const Triangle &triangle = scene.triangles[i];
        const int body = bodies.of_triangle[i];
        if (body >= 0
            && triangle.material != bodies.list[static_cast<std::size_t>(body)].material) {
            throw UserError(fmt::format(
                "{}: one body of several dielectrics: POV-Ray's objects have one interior each; "
                "give the mesh a material to export the scene",
                to_string(scene.meshes[static_cast<std::size_t>(triangle.mesh)].where)));
        }
    }
}

// A ray starts with the interiors of all objects that hold the eye. Inverting an object swaps its
// inside and its outside, and with them the textures of the two sides, but nothing else.
const char *inverse(bool is_inverse) {
    return is_inverse ? " inverse" : "";
}

std::string two_sided(const std::string &shape, std::string outside, std::string inside,
                      bool is_inverse) {
    if (is_inverse) {
        std::swap(outside, inside);
    }
    return fmt::format("object {{ {} texture {{ {} }} interior_texture {{ {} }} hollow{} }}\n",
                       shape, outside, inside, inverse(is_inverse));
}

}  // namespace

Media::Media(const Scene &scene)
    : bodies_(bodies_of(scene)), overlapping_(bodies_.list.size()),
      holds_eye_(bodies_.list.size()) {
    require_one_material_each(scene, bodies_);
    const auto is_closed = [this](int body) {
        return bodies_.list[static_cast<std::size_t>(body)].is_closed;
    };
    for (const auto &[one, other] : bodies_.meeting) {
        if (is_closed(one) && is_closed(other)) {
            overlapping_[static_cast<std::size_t>(one)].push_back(other);
            overlapping_[static_cast<std::size_t>(other)].push_back(one);
        }
    }
    for (std::vector<int> &others : overlapping_) {
        std::ranges::sort(others);
    }
    for (const int body : bodies_at(scene, bodies_, scene.camera.position)) {
        holds_eye_[static_cast<std::size_t>(body)] = true;
        eye_medium_ = body;
    }
}

bool Media::have_shells() const {
    return std::ranges::any_of(overlapping_, [](const auto &others) { return !others.empty(); });
}

// Leaves of the body's surface where it lies in `outside`, or in air for -1: no higher body holds
// the place, and no lower one above `outside` does.
std::string Media::clip(int body, int outside) const {
    std::string list;
    for (const int other : overlapping_[static_cast<std::size_t>(body)]) {
        if (other >= outside) {
            list += fmt::format(" object {{ body_{}{} }}", other, inverse(other != outside));
        }
    }
    return list.empty() ? "" : fmt::format(" clipped_by {{{} }}", list);
}

// To the objects of each medium, the surfaces that rays enter or leave it by.
void Media::add_surfaces(int body, std::vector<std::string> &of_medium) const {
    const bool is_inverse = holds_eye(body);
    const std::string glass =
        fmt::format("material_{}", bodies_.list[static_cast<std::size_t>(body)].material);
    std::string &inside = of_medium[static_cast<std::size_t>(body)];
    inside += fmt::format("object {{ body_{}{} texture {{ {} }} hollow{} }}\n", body,
                          clip(body, -1), glass, inverse(is_inverse && body != eye_medium_));
    for (const int outside : overlapping_[static_cast<std::size_t>(body)]) {
        if (outside < body) {
            const std::string clipped = clip(body, outside);
            inside +=
                two_sided(fmt::format("shell_{}{}", body, clipped), glass, "through", is_inverse);
            of_medium[static_cast<std::size_t>(outside)] +=
                two_sided(fmt::format("body_{}{}", body, clipped), "through", glass, is_inverse);
        }
    }
}

// `interior { NAME }` makes a copy, and POV-Ray compares interiors by address, so the surfaces of a
// medium take theirs from one union.
std::string Media::objects(const std::vector<Shape> &shapes) const {
    std::string text = "#declare through = texture { pigment { rgb 1 filter 1 } finish { ambient 0 "
                       "diffuse 0 } }\n";
    std::vector<std::string> of_medium(bodies_.list.size());
    for (int body = 0; body < static_cast<int>(shapes.size()); ++body) {
        const Shape &shape = shapes[static_cast<std::size_t>(body)];
        if (affected(body) < 0) {
            continue;
        }
        text += fmt::format("#declare body_{} = {}\n", body, shape.surface);
        if (overlaps(body)) {
            text += fmt::format("#declare shell_{} = {}\n", body, shape.outer_shell);
        }
        text += fmt::format("object {{ body_{} pigment {{ rgb 0 }} hollow no_image no_reflection{} "
                            "}}\n",
                            body, inverse(holds_eye(body)));
        add_surfaces(body, of_medium);
    }
    for (std::size_t body = 0; body < of_medium.size(); ++body) {
        if (!of_medium[body].empty()) {
            text += fmt::format("union {{\n{}interior {{ interior_{} }} no_shadow }}\n",
                                of_medium[body], bodies_.list[body].material);
        }
    }
    return text;
}

Scene enlarged(Scene scene, double factor) {
    scene.camera.position *= factor;
    scene.camera.look_at *= factor;
    for (Sphere &sphere : scene.spheres) {
        sphere.center *= factor;
        sphere.radius *= factor;
    }
    for (Plane &plane : scene.planes) {
        plane.point *= factor;
    }
    for (Vertex &vertex : scene.vertices) {
        vertex.position *= factor;
    }
    for (Material &material : scene.materials) {
        material.absorption /= factor;
    }
    for (Light &light : scene.lights) {
        light.position *= factor;
        light.intensity *= light.type == LightType::point ? factor * factor : 1;
    }
    return scene;
}

}  // namespace stagelight::pov
