// SPDX-License-Identifier: MIT
#include "scene/bodies.h"
#include <algorithm>
#include <numeric>
#include <tuple>
#include <glm/geometric.hpp>
namespace stagelight {
namespace {
bool is_glass(const Scene &s, int m) { return s.materials[std::size_t(m)].type == MaterialType::dielectric; }
}
Bodies bodies_of(const Scene &scene) {
    struct One { Body body; int kind; std::size_t index; };
    std::vector<One> ones;
    for (std::size_t i = 0; i < scene.planes.size(); ++i)
        if (is_glass(scene, scene.planes[i].material)) ones.push_back({{scene.planes[i].material, INFINITY}, 1, i});
    for (std::size_t i = 0; i < scene.spheres.size(); ++i)
        if (is_glass(scene, scene.spheres[i].material)) ones.push_back({{scene.spheres[i].material, 4.18879 * std::pow(scene.spheres[i].radius, 3)}, 0, i});
    for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
        double volume = 0; int material = -1;
        for (const Triangle &t : scene.triangles) if (t.mesh == int(m) && is_glass(scene, t.material)) {
            material = t.material;
            volume += glm::dot(scene.vertices[t.vertices[0]].position, glm::cross(scene.vertices[t.vertices[1]].position, scene.vertices[t.vertices[2]].position)) / 6;
        }
        if (material >= 0) ones.push_back({{material, std::abs(volume)}, 2, m});
    }
    std::ranges::stable_sort(ones, [&](const One &a, const One &b) {
        const int pa = scene.materials[std::size_t(a.body.material)].priority, pb = scene.materials[std::size_t(b.body.material)].priority;
        return std::tuple(pa, -a.body.volume) < std::tuple(pb, -b.body.volume);
    });
    Bodies bodies;
    bodies.of_sphere.assign(scene.spheres.size(), -1);
    bodies.of_plane.assign(scene.planes.size(), -1);
    bodies.of_triangle.assign(scene.triangles.size(), -1);
    for (std::size_t i = 0; i < ones.size(); ++i) {
        bodies.list.push_back(ones[i].body);
        if (ones[i].kind == 0) bodies.of_sphere[ones[i].index] = int(i);
        if (ones[i].kind == 1) bodies.of_plane[ones[i].index] = int(i);
        if (ones[i].kind == 2) for (std::size_t t = 0; t < scene.triangles.size(); ++t) if (scene.triangles[t].mesh == int(ones[i].index) && is_glass(scene, scene.triangles[t].material)) bodies.of_triangle[t] = int(i);
        for (std::size_t j = 0; j < i; ++j) {
            bool meet = false;
            if (ones[i].kind == 0 && ones[j].kind == 0) {
                const auto &a = scene.spheres[ones[i].index], &b = scene.spheres[ones[j].index];
                meet = glm::distance(a.center, b.center) <= a.radius + b.radius;
            } else meet = ones[i].kind == 1 || ones[j].kind == 1;
            if (meet) bodies.meeting.emplace_back(int(j), int(i));
        }
    }
    return bodies;
}
std::vector<int> bodies_at(const Scene &scene, const Bodies &bodies, const glm::dvec3 &point) {
    std::vector<int> found;
    for (std::size_t i = 0; i < scene.spheres.size(); ++i)
        if (bodies.of_sphere[i] >= 0 && glm::distance(point, scene.spheres[i].center) < scene.spheres[i].radius) found.push_back(bodies.of_sphere[i]);
    for (std::size_t i = 0; i < scene.planes.size(); ++i)
        if (bodies.of_plane[i] >= 0 && glm::dot(point - scene.planes[i].point, scene.planes[i].normal) < 0) found.push_back(bodies.of_plane[i]);
    std::ranges::sort(found);
    return found;
}
}  // namespace stagelight
