// SPDX-License-Identifier: MIT
// Small scenes with a known answer, and what a single ray sees of them.
#pragma once

#include <iomanip>
#include <numbers>
#include <random>
#include <source_location>
#include <sstream>
#include <string>

#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include "reference/tracer.h"
#include "scene/scene.h"

namespace stagelight::reference {

using dvec3 = glm::dvec3;

inline int add_material(Scene &scene, Material material) {
    scene.materials.push_back(material);
    return int(scene.materials.size()) - 1;
}

inline Material diffuse(dvec3 color) {
    return {.color = color, .where = {}};
}

inline Material mirror(dvec3 color) {
    return {.type = MaterialType::mirror, .color = color, .where = {}};
}

inline Material glossy(dvec3 color, double specularity) {
    return {.type = MaterialType::glossy, .color = color, .specularity = specularity, .where = {}};
}

inline Material glass(dvec3 color, double ior, dvec3 absorption) {
    return {.type = MaterialType::dielectric,
            .color = color,
            .ior = ior,
            .absorption = absorption,
            .where = {}};
}

inline void add_sphere(Scene &scene, dvec3 center, double radius, Material material) {
    scene.spheres.push_back({.center = center,
                             .radius = radius,
                             .material = add_material(scene, material),
                             .where = {}});
}

inline void add_plane(Scene &scene, dvec3 normal, dvec3 point, Material material) {
    scene.planes.push_back(
        {.normal = normal, .point = point, .material = add_material(scene, material), .where = {}});
}

inline void add_point_light(Scene &scene, dvec3 position, dvec3 color, double intensity) {
    scene.lights.push_back(
        {.position = position, .color = color, .intensity = intensity, .where = {}});
}

inline void add_directional_light(Scene &scene, dvec3 direction, dvec3 color, double intensity) {
    scene.lights.push_back({.type = LightType::directional,
                            .direction = direction,
                            .color = color,
                            .intensity = intensity,
                            .where = {}});
}

inline Texture texture_of(int width, int height, std::vector<std::uint8_t> texels) {
    return {.file = {}, .width = width, .height = height, .texels = texels, .where = {}};
}

// A triangle with corners of its own.
inline void add_triangle(Scene &scene, const Vertex &a, const Vertex &b, const Vertex &c,
                         int material = 0) {
    if (scene.meshes.empty())
        scene.meshes.emplace_back();
    const auto first = std::uint32_t(scene.vertices.size());
    scene.vertices.insert(scene.vertices.end(), {a, b, c});
    scene.triangles.push_back({.vertices = {first, first + 1, first + 2}, .material = material});
}

inline void add_flat_triangle(Scene &scene, dvec3 a, dvec3 b, dvec3 c, int material = 0) {
    const dvec3 n = glm::normalize(glm::cross(b - a, c - a));
    add_triangle(scene, {a, n, {}}, {b, n, {}}, {c, n, {}}, material);
}

// A ball of n * 2n facets with the normals of a sphere.
inline void add_ball(Scene &scene, dvec3 center, double radius, int n, int material) {
    const auto at = [&](int row, int column) {
        const double polar = std::numbers::pi * row / n, turn = std::numbers::pi * column / n;
        const dvec3 normal(std::sin(polar) * std::sin(turn), std::cos(polar),
                           std::sin(polar) * std::cos(turn));
        return Vertex{center + radius * normal, normal, {0.5 * column / n, 1.0 * row / n}};
    };
    for (int row = 0; row < n; ++row)
        for (int column = 0; column < 2 * n; ++column) {
            // The last column is the first again, to the bit.
            const int next = (column + 1) % (2 * n);
            add_triangle(scene, at(row, column), at(row + 1, column), at(row + 1, next), material);
            add_triangle(scene, at(row, column), at(row + 1, next), at(row, next), material);
        }
}

// A closed box of twelve facets.
inline void add_box(Scene &scene, dvec3 low, dvec3 high, int material) {
    const dvec3 center = (low + high) / 2.0, half = (high - low) / 2.0;
    for (const int axis : {0, 1, 2})
        for (const double side : {-1.0, 1.0}) {
            dvec3 out(0), right(0);
            out[axis] = side * half[axis];
            right[(axis + 1) % 3] = side * half[(axis + 1) % 3];
            dvec3 up(0);
            up[(axis + 2) % 3] = half[(axis + 2) % 3];
            const dvec3 face = center + out;
            add_flat_triangle(scene, face - right - up, face + right - up, face + right + up,
                              material);
            add_flat_triangle(scene, face - right - up, face + right + up, face - right + up,
                              material);
        }
}

template <typename Number = double> Ray<Number> ray(dvec3 origin, dvec3 direction) {
    return {Vec<Number>(origin), glm::normalize(Vec<Number>(direction))};
}

// The tree of what the ray meets.
inline RayTree met(const Scene &scene, const Ray<double> &along, const Settings &settings = {}) {
    const World<double> world(scene);
    RayTree tree;
    Tracer<double>(world, settings).light(along, tree);
    return tree;
}

inline dvec3 seen(const Scene &scene, const Ray<double> &along, const Settings &settings = {}) {
    const World<double> world(scene);
    RayTree tree;
    return Tracer<double>(world, settings).light(along, tree);
}

inline std::string text(dvec3 v) {
    std::ostringstream out;
    out << std::setprecision(15) << '(' << v.x << ", " << v.y << ", " << v.z << ')';
    return out.str();
}

// A NaN is near nothing.
inline void expect_near(dvec3 value, dvec3 expected, double tolerance,
                        std::source_location at = std::source_location::current()) {
    if (!(glm::distance(value, expected) <= tolerance))
        ADD_FAILURE_AT(at.file_name(), int(at.line()))
            << "is " << text(value) << ", expected " << text(expected) << " within " << tolerance
            << ", off by " << glm::distance(value, expected);
}

// Directions and points with no pattern, the same in each run.
class Dice {
public:
    double between(double low, double high) {
        return low + (high - low) * double(engine_()) / double(std::mt19937::max());
    }
    dvec3 in_cube(double half) {
        const double x = between(-half, half), y = between(-half, half);
        return {x, y, between(-half, half)};
    }
    dvec3 direction() {
        for (;;)
            if (const dvec3 v = in_cube(1); glm::length(v) > 0.1 && glm::length(v) < 1)
                return glm::normalize(v);
    }

private:
    std::mt19937 engine_{20161206};
};

}  // namespace stagelight::reference
