// SPDX-License-Identifier: MIT
#include "pov/pov_shapes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "pov/pov_materials.h"
#include "scene/places.h"

namespace stagelight::pov {
namespace {

const Material &material_of(const Scene &scene, int material) {
    return scene.materials[static_cast<std::size_t>(material)];
}

// A shape in its material. Everything is hollow: POV-Ray leaves out the media of a ray that starts
// in something that is not, and half of space is in a plane. What holds the eye is inverted, or all
// rays would start with its interior. Glass would let light through: its shadow is cast by another
// of its kind, that is black and not seen.
std::string placed(const Scene &scene, const std::string &shape, int material,
                   const char *kind = "", bool holds_eye = false) {
    if (material_of(scene, material).type != MaterialType::dielectric) {
        return fmt::format("object {{ {} texture {{ {}material_{} }} hollow{} }}\n", shape, kind,
                           material, holds_eye ? " inverse" : "");
    }
    return fmt::format(
        "object {{ {0} texture {{ material_{1} }} interior {{ interior_{1} }} hollow "
        "no_shadow }}\n"
        "object {{ {0} pigment {{ rgb 0 }} hollow no_image no_reflection }}\n",
        shape, material);
}

// The scene's shapes, but for those that `media` makes objects of.
class Shapes {
public:
    Shapes(const Scene &scene, const Media &media) : scene_(scene), media_(media) {}

    std::string text() {
        for (std::size_t i = 0; i < scene_.spheres.size(); ++i) {
            add_sphere(scene_.spheres[i], media_.of_sphere(i));
        }
        for (std::size_t i = 0; i < scene_.planes.size(); ++i) {
            add_plane(scene_.planes[i], media_.of_plane(i));
        }
        add_meshes();
        return shapes_.empty() ? text_ : text_ + media_.objects(shapes_);
    }

private:
    void add_sphere(const Sphere &sphere, int body);
    void add_plane(const Plane &plane, int body);
    void add_meshes();
    void add_body(int body, Media::Shape shape) {
        const auto index = static_cast<std::size_t>(body);
        shapes_.resize(std::max(shapes_.size(), index + 1));
        shapes_[index] = std::move(shape);
    }

    const Scene &scene_;
    const Media &media_;
    std::string text_;
    std::vector<Media::Shape> shapes_;  // by body
};

void Shapes::add_sphere(const Sphere &sphere, int body) {
    const auto text = [&](double radius) {
        return fmt::format("sphere {{ {}, {} }}", vector(sphere.center), radius);
    };
    if (body >= 0) {
        add_body(body, {text(sphere.radius), text(sphere.radius + shell_distance)});
        return;
    }
    const bool is_textured = material_of(scene_, sphere.material).texture != no_texture;
    text_ += placed(scene_, text(sphere.radius), sphere.material, is_textured ? "sphere_" : "",
                    glm::distance(scene_.camera.position, sphere.center) < sphere.radius);
}

void Shapes::add_plane(const Plane &plane, int body) {
    const auto text = [&](double further) {
        return fmt::format("plane {{ {}, {} }}", vector(plane.normal),
                           glm::dot(plane.normal, plane.point) + further);
    };
    if (body >= 0) {
        add_body(body, {text(0), text(shell_distance)});
        return;
    }
    text_ += placed(scene_, text(0), plane.material, "",
                    glm::dot(plane.normal, scene_.camera.position - plane.point) < 0);
}

// Triangles of one material of one mesh, and the vertices that they use.
struct Part {
    std::map<std::uint32_t, std::size_t> places;  // of the scene's vertices among these
    std::vector<std::uint32_t> vertices;
    std::vector<Triangle> triangles;
};

void add(Part &part, const Triangle &triangle) {
    for (const std::uint32_t vertex : triangle.vertices) {
        if (part.places.try_emplace(vertex, part.vertices.size()).second) {
            part.vertices.push_back(vertex);
        }
    }
    part.triangles.push_back(triangle);
}

// Where the vertices of a body are once each of its faces has moved outwards by shell_distance, or
// by a little more.
std::map<std::uint32_t, glm::dvec3> moved_outwards(const Scene &scene, const Part &part) {
    const std::vector<std::uint32_t> places = places_of(scene.vertices);
    struct Corner {
        glm::dvec3 outwards{0};  // the faces' normals, each by its angle
        std::vector<glm::dvec3> normals;
    };
    std::map<std::uint32_t, Corner> corners;
    for (const Triangle &triangle : part.triangles) {
        for (std::size_t i = 0; i < 3; ++i) {
            const auto at = [&](std::size_t corner) {
                return scene.vertices[triangle.vertices[corner % 3]].position;
            };
            const glm::dvec3 a = glm::normalize(at(i + 1) - at(i));
            const glm::dvec3 b = glm::normalize(at(i + 2) - at(i));
            const glm::dvec3 normal = glm::normalize(glm::cross(a, b));
            Corner &corner = corners[places[triangle.vertices[i]]];
            corner.outwards += std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0)) * normal;
            corner.normals.push_back(normal);
        }
    }
    std::map<std::uint32_t, glm::dvec3> moved;
    for (const std::uint32_t vertex : part.vertices) {
        const Corner &corner = corners[places[vertex]];
        const glm::dvec3 outwards = glm::normalize(corner.outwards);
        double least = 1;
        for (const glm::dvec3 &normal : corner.normals) {
            least = std::min(least, glm::dot(normal, outwards));
        }
        constexpr double sharp = 0.1;  // else a needle's tip would move far
        moved[vertex] =
            scene.vertices[vertex].position + shell_distance / std::max(least, sharp) * outwards;
    }
    return moved;
}

std::string list(const char *name, const Part &part, const auto &entry) {
    std::string text = fmt::format("{} {{ {}", name, part.vertices.size());
    for (const std::uint32_t vertex : part.vertices) {
        text += ",\n" + entry(vertex);
    }
    return text + " }\n";
}

// A texture for each vertex, which POV-Ray blends.
std::string colors(const Scene &scene, const Part &part) {
    return list("texture_list", part, [&](std::uint32_t vertex) {
        Material material = material_of(scene, part.triangles.front().material);
        material.color *= scene.vertices[vertex].color;
        return texture_of(material);
    });
}

// POV-Ray is left-handed: with the corners in our order, its normal of a flat face points inwards.
std::string faces(const Part &part, bool has_colors) {
    std::string text = fmt::format("face_indices {{ {}", part.triangles.size());
    for (const Triangle &triangle : part.triangles) {
        const auto &[a, b, c] = triangle.vertices;
        const std::string corners =
            fmt::format("{}, {}, {}", part.places.at(a), part.places.at(c), part.places.at(b));
        text += fmt::format(",\n<{}>{}", corners, has_colors ? ", " + corners : "");
    }
    return text + " }\n";
}

std::string mesh(const Scene &scene, const Part &part, const auto &position, const char *more) {
    std::string text = "mesh2 {\n";
    text += list("vertex_vectors", part,
                 [&](std::uint32_t vertex) { return vector(position(vertex)); });
    text += list("normal_vectors", part,
                 [&](std::uint32_t vertex) { return vector(scene.vertices[vertex].normal); });
    if (material_of(scene, part.triangles.front().material).texture != no_texture) {
        text += list("uv_vectors", part, [&](std::uint32_t vertex) {
            const glm::dvec2 uv = scene.vertices[vertex].texture_coordinates;
            return fmt::format("<{}, {}>", uv.x, 1 - uv.y);  // POV-Ray's goes up
        });
    }
    const bool has_colors = std::ranges::any_of(
        part.triangles, [&](const Triangle &triangle) { return has_color(scene, triangle); });
    if (has_colors) {
        text += colors(scene, part);
    }
    return text + faces(part, has_colors) + more + "}";
}

void Shapes::add_meshes() {
    std::map<std::tuple<int, int, int>, Part> parts;  // by mesh, material and body
    for (std::size_t i = 0; i < scene_.triangles.size(); ++i) {
        const Triangle &triangle = scene_.triangles[i];
        add(parts[{triangle.mesh, triangle.material, media_.of_triangle(i)}], triangle);
    }
    for (const auto &[key, part] : parts) {
        const auto [number, material, body] = key;
        const auto in_place = [&](std::uint32_t vertex) {
            return scene_.vertices[vertex].position;
        };
        if (body >= 0) {
            // POV-Ray counts the faces in this direction to tell what is inside. It lies in the
            // plane of no likely face.
            const char *inside = "inside_vector <0.3711, 0.8747, 0.3112>\n";
            const auto shell = moved_outwards(scene_, part);
            add_body(body,
                     {mesh(scene_, part, in_place, inside),
                      mesh(
                          scene_, part, [&](auto vertex) { return shell.at(vertex); }, inside)});
            continue;
        }
        const std::string name = fmt::format("mesh_{}_{}", number, material);
        text_ += fmt::format("#declare {} = {}\n", name, mesh(scene_, part, in_place, ""));
        text_ += placed(scene_, name, material);
    }
}

}  // namespace

std::string shapes(const Scene &scene, const Media &media) {
    return Shapes(scene, media).text();
}

}  // namespace stagelight::pov
