// SPDX-License-Identifier: MIT
#include "pov/pov_shapes.h"

#include <map>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "pov/pov_materials.h"

namespace stagelight::pov {
namespace {

const Material &material_of(const Scene &scene, int material) {
    return scene.materials[static_cast<std::size_t>(material)];
}

// A shape in its material. Everything is hollow: POV-Ray leaves out the media of a ray that starts
// in something that is not, and half of space is in a plane. Glass would let light through: its
// shadow is cast by another of its kind, that is black and not seen.
std::string placed(const Scene &scene, const std::string &shape, int material,
                   const char *kind = "") {
    if (material_of(scene, material).type != MaterialType::dielectric) {
        return fmt::format("object {{ {} texture {{ {}material_{} }} hollow }}\n", shape, kind,
                           material);
    }
    return fmt::format(
        "object {{ {0} texture {{ material_{1} }} interior {{ interior_{1} }} hollow "
        "no_shadow }}\n"
        "object {{ {0} pigment {{ rgb 0 }} hollow no_image no_reflection }}\n",
        shape, material);
}

std::string sphere(const Scene &scene, const Sphere &sphere) {
    const bool is_textured = material_of(scene, sphere.material).texture != no_texture;
    return placed(scene, fmt::format("sphere {{ {}, {} }}", vector(sphere.center), sphere.radius),
                  sphere.material, is_textured ? "sphere_" : "");
}

std::string plane(const Scene &scene, const Plane &plane) {
    return placed(scene,
                  fmt::format("plane {{ {}, {} }}", vector(plane.normal),
                              glm::dot(plane.normal, plane.point)),
                  plane.material);
}

// Triangles of one material of one mesh, and the vertices that they use.
struct Part {
    std::map<std::uint32_t, std::size_t> places;  // of the scene's vertices among these
    std::vector<const Vertex *> vertices;
    std::string faces;
    std::size_t face_count = 0;
};

std::size_t place_of(Part &part, const Scene &scene, std::uint32_t vertex) {
    const auto [place, is_new] = part.places.try_emplace(vertex, part.vertices.size());
    if (is_new) {
        part.vertices.push_back(&scene.vertices[vertex]);
    }
    return place->second;
}

void add(Part &part, const Scene &scene, const Triangle &triangle) {
    const auto &[a, b, c] = triangle.vertices;
    const std::size_t first = place_of(part, scene, a);
    const std::size_t second = place_of(part, scene, b);
    const std::size_t third = place_of(part, scene, c);
    part.faces += fmt::format(",\n<{}, {}, {}>", first, second, third);
    ++part.face_count;
}

std::string list(const char *name, const std::vector<const Vertex *> &vertices, const auto &entry) {
    std::string text = fmt::format("{} {{ {}", name, vertices.size());
    for (const Vertex *vertex : vertices) {
        text += ",\n" + entry(*vertex);
    }
    return text + " }\n";
}

std::string mesh(const Part &part, bool is_textured) {
    std::string text = "mesh2 {\n";
    text += list("vertex_vectors", part.vertices,
                 [](const Vertex &vertex) { return vector(vertex.position); });
    text += list("normal_vectors", part.vertices,
                 [](const Vertex &vertex) { return vector(vertex.normal); });
    if (is_textured) {
        text += list("uv_vectors", part.vertices, [](const Vertex &vertex) {
            const auto [u, v] =
                std::pair(vertex.texture_coordinates.x, vertex.texture_coordinates.y);
            return fmt::format("<{}, {}>", u, 1 - v);  // POV-Ray's goes up
        });
    }
    return text + fmt::format("face_indices {{ {}{} }}\n}}", part.face_count, part.faces);
}

std::string meshes(const Scene &scene) {
    std::map<std::pair<int, int>, Part> parts;  // by mesh and material
    for (const Triangle &triangle : scene.triangles) {
        add(parts[{triangle.mesh, triangle.material}], scene, triangle);
    }
    std::string text;
    for (const auto &[key, part] : parts) {
        const auto [number, material] = key;
        const std::string name = fmt::format("mesh_{}_{}", number, material);
        const bool is_textured = material_of(scene, material).texture != no_texture;
        text += fmt::format("#declare {} = {}\n", name, mesh(part, is_textured));
        text += placed(scene, name, material);
    }
    return text;
}

}  // namespace

std::string shapes(const Scene &scene) {
    std::string text;
    for (const Sphere &shape : scene.spheres) {
        text += sphere(scene, shape);
    }
    for (const Plane &shape : scene.planes) {
        text += plane(scene, shape);
    }
    return text + meshes(scene);
}

}  // namespace stagelight::pov
