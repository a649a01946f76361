// SPDX-License-Identifier: MIT
#include "bench/generated_scenes.h"

#include <cmath>
#include <cstdint>
#include <numbers>

#include <glm/geometric.hpp>

namespace stagelight::bench {
namespace {

constexpr int picture_size = 512;

// A torus about the y axis; u around the ring, v around its tube, both in whole turns.
glm::dvec3 point_on_ring(double u, double v) {
    constexpr double radius = 1, tube = 0.4, wave = 0.03;
    const double a = 2 * std::numbers::pi * u, b = 2 * std::numbers::pi * v;
    const double thickness = tube + wave * std::sin(6 * a) * std::sin(3 * b);
    const double across = radius + thickness * std::cos(b);
    return {across * std::cos(a), thickness * std::sin(b), across * std::sin(a)};
}

Vertex vertex_on_ring(double u, double v) {
    constexpr double step = 1e-4;
    const glm::dvec3 along_u = point_on_ring(u + step, v) - point_on_ring(u - step, v);
    const glm::dvec3 along_v = point_on_ring(u, v + step) - point_on_ring(u, v - step);
    return {point_on_ring(u, v), glm::normalize(glm::cross(along_v, along_u)), {u, v}};
}

// Of 2n by n squares.
void add_ring(Scene &scene, int n) {
    const int columns = 2 * n;
    for (int column = 0; column < columns; ++column) {
        for (int row = 0; row < n; ++row) {
            scene.vertices.push_back(vertex_on_ring(static_cast<double>(column) / columns,
                                                    static_cast<double>(row) / n));
        }
    }
    const auto at = [n, columns](int column, int row) {
        return static_cast<std::uint32_t>(column % columns * n + row % n);
    };
    for (int column = 0; column < columns; ++column) {
        for (int row = 0; row < n; ++row) {
            const std::uint32_t a = at(column, row), b = at(column, row + 1);
            const std::uint32_t c = at(column + 1, row + 1), d = at(column + 1, row);
            scene.triangles.push_back({{a, b, c}});
            scene.triangles.push_back({{a, c, d}});
        }
    }
}

Light point_light(const glm::dvec3 &position, double intensity) {
    Light light;
    light.position = position;
    light.intensity = intensity;
    return light;
}

Scene empty_scene(const glm::dvec3 &eye, const glm::dvec3 &look_at) {
    Scene scene;
    scene.width = scene.height = picture_size;
    scene.camera.position = eye;
    scene.camera.look_at = look_at;
    scene.camera.fov = 40;
    scene.background = {0.2, 0.25, 0.3};
    scene.materials.emplace_back();
    return scene;
}

Scene ring_without_light(int n) {
    Scene scene = empty_scene({0, 2.6, 3.4}, {0, 0, 0});
    scene.meshes.emplace_back();
    add_ring(scene, n);
    return scene;
}

}  // namespace

Scene ring(int n) {
    Scene scene = ring_without_light(n);
    scene.lights.push_back(point_light({2, 5, 3}, 25));
    return scene;
}

Scene ring_in_lights(int count) {
    Scene scene = ring_without_light(64);
    for (int i = 0; i < count; ++i) {
        const double turn = 2 * std::numbers::pi * i / count;
        scene.lights.push_back(
            point_light({4 * std::cos(turn), 4, 4 * std::sin(turn)}, 25.0 / count));
    }
    return scene;
}

Scene facing_mirrors(int depth) {
    Scene scene = empty_scene({0.6, 0.2, 0.9}, {0.25, 0.05, -1});
    scene.max_depth = depth;
    scene.has_max_depth = true;
    Material mirror;
    mirror.type = MaterialType::mirror;
    mirror.color = {0.95, 0.95, 0.95};
    scene.materials.push_back(mirror);
    scene.spheres.emplace_back();
    scene.spheres.back().radius = 0.3;
    for (const double side : {-1.0, 1.0}) {
        Plane plane;
        plane.normal = {0, 0, -side};
        plane.point = {0, 0, side};
        plane.material = 1;
        scene.planes.push_back(plane);
    }
    scene.lights.push_back(point_light({0, 3, 0.5}, 6));
    return scene;
}

}  // namespace stagelight::bench
