// SPDX-License-Identifier: MIT
#include "scene/outward_normals.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <unordered_set>

#include <glm/geometric.hpp>

#include "scene/mesh_surface.h"
#include "scene/normalize.h"

namespace stagelight {
namespace {

// How far the normals of the three vertices point outwards, 1 for all the way.
std::array<double, 3> outwards(const Scene &scene, const Triangle &triangle) {
    const auto [a, b, c] = corners_of(scene, triangle);
    const glm::dvec3 facet = normalize(glm::cross(b - a, c - a));
    std::array<double, 3> found{};
    std::ranges::transform(triangle.vertices, found.begin(), [&](std::uint32_t vertex) {
        return glm::dot(facet, scene.vertices[vertex].normal);
    });
    return found;
}

// Appends the triangles of a part whose normals point inwards. A file's normals follow its
// triangles, right or wrong, or are right though the triangles are not. A single normal, which may
// lean, can't tell; so those that were turned decide as one, and those that were not.
void add_inwards(std::vector<std::uint32_t> &inwards, const Scene &scene, const Part &part,
                 const std::vector<bool> &turned) {
    std::array<double, 2> sums{};
    for (const std::uint32_t index : part.triangles) {
        for (const double one : outwards(scene, scene.triangles[index])) {
            sums[turned[index] ? 1 : 0] += one;
        }
    }
    // Some files have a single face with wrong normals. No smooth one leans as far as that.
    constexpr double cos_120_degrees = -0.5;
    for (const std::uint32_t index : part.triangles) {
        const bool is_wrong =
            turned[index] ? sums[1] < 0
                          : part.has_inside
                                && (sums[0] < 0
                                    || std::ranges::max(outwards(scene, scene.triangles[index]))
                                           < cos_120_degrees);
        if (is_wrong) {
            inwards.push_back(index);
        }
    }
}

}  // namespace

void point_normals_outwards(Scene &scene, std::vector<std::uint32_t> &places,
                            const std::vector<Part> &parts, const std::vector<bool> &turned) {
    std::vector<std::uint32_t> inwards;
    for (const Part &part : parts) {
        add_inwards(inwards, scene, part, turned);
    }
    if (inwards.empty()) {
        return;
    }
    const std::unordered_set<std::uint32_t> wrong(inwards.begin(), inwards.end());
    std::unordered_set<std::uint32_t> right_vertices;
    for (const Part &part : parts) {
        for (const std::uint32_t index : part.triangles) {
            if (!wrong.contains(index)) {
                right_vertices.insert(scene.triangles[index].vertices.begin(),
                                      scene.triangles[index].vertices.end());
            }
        }
    }
    std::unordered_map<std::uint32_t, std::uint32_t> negated;
    for (const std::uint32_t index : inwards) {
        for (std::uint32_t &vertex : scene.triangles[index].vertices) {
            const auto [known, is_new] = negated.emplace(vertex, vertex);
            if (is_new) {
                if (right_vertices.contains(vertex)) {
                    known->second = static_cast<std::uint32_t>(scene.vertices.size());
                    scene.vertices.push_back(Vertex(scene.vertices[vertex]));
                    places.push_back(places[vertex]);
                }
                Vertex &turned_vertex = scene.vertices[known->second];
                turned_vertex.normal = -turned_vertex.normal;
            }
            vertex = known->second;
        }
    }
}

}  // namespace stagelight
