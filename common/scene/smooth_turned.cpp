// SPDX-License-Identifier: MIT
#include "scene/smooth_turned.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "scene/mesh_surface.h"
#include "scene/normalize.h"

namespace stagelight {
namespace {

struct Corner {
    std::uint32_t triangle;
    std::size_t number;
    glm::dvec3 facet;  // the triangle's normal
};

// As Assimp's GenSmoothNormals has it, with the angle that mesh_file.cpp gives it: of the triangles
// at a place, those that don't turn away from this one too far.
template <typename Counts>
glm::dvec3 smooth_normal(const std::vector<Corner> &around, const Corner &corner,
                         const Counts &counts) {
    const double limit = std::cos(glm::radians(66.0));
    glm::dvec3 sum(0);
    for (const Corner &other : around) {
        if (counts(other) && glm::dot(other.facet, corner.facet) >= limit) {
            sum += other.facet;
        }
    }
    return sum;
}

// Whether normals at a place were made like that, from the triangles that were right.
bool were_made(const Scene &scene, const std::vector<Corner> &around,
               const std::vector<bool> &turned) {
    for (const Corner &corner : around) {
        const glm::dvec3 &normal =
            scene.vertices[scene.triangles[corner.triangle].vertices[corner.number]].normal;
        const glm::dvec3 made = smooth_normal(around, corner, [&](const Corner &other) {
            return turned[other.triangle] == turned[corner.triangle];
        });
        if (glm::distance(normalize(made), normal) > 1e-3) {
            return false;
        }
    }
    return true;
}

}  // namespace

void smooth_turned(Scene &scene, std::vector<std::uint32_t> &places, const Part &part,
                   const std::vector<bool> &turned) {
    std::map<std::uint32_t, std::vector<Corner>> around;  // places of turned triangles
    const auto each_corner = [&](bool of_turned, const auto &visit) {
        for (const std::uint32_t index : part.triangles) {
            for (std::size_t i = 0; i < 3 && (turned[index] || !of_turned); ++i) {
                visit(index, i, places[scene.triangles[index].vertices[i]]);
            }
        }
    };
    each_corner(true, [&](std::uint32_t, std::size_t, std::uint32_t place) { around[place]; });
    if (around.empty()) {
        return;
    }
    each_corner(false, [&](std::uint32_t index, std::size_t i, std::uint32_t place) {
        if (const auto found = around.find(place); found != around.end()) {
            const auto [a, b, c] = corners_of(scene, scene.triangles[index]);
            found->second.push_back({index, i, normalize(glm::cross(b - a, c - a))});
        }
    });
    for (const auto &[place, corners] : around) {
        if (std::ranges::all_of(corners, [&](const Corner &c) { return turned[c.triangle]; })
            || !were_made(scene, corners, turned)) {
            continue;
        }
        for (const Corner &corner : corners) {
            std::uint32_t &vertex = scene.triangles[corner.triangle].vertices[corner.number];
            Vertex smoothed = scene.vertices[vertex];
            smoothed.normal =
                normalize(smooth_normal(corners, corner, [](const Corner &) { return true; }));
            vertex = static_cast<std::uint32_t>(scene.vertices.size());
            scene.vertices.push_back(smoothed);
            places.push_back(place);
        }
    }
}

}  // namespace stagelight
