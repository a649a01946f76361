// SPDX-License-Identifier: MIT
#include "scene/closed_mesh.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include <fmt/format.h>

#include "scene/dielectrics.h"
#include "scene/places.h"

namespace stagelight {
namespace {

struct Edge {
    int mesh;
    std::uint32_t low, high;  // its ends' places
    // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 takes its 0 for a pointer
    auto operator<=>(const Edge &) const = default;
};

std::vector<Edge> dielectric_edges(const Scene &scene) {
    std::vector<std::uint32_t> places;
    std::vector<Edge> edges;
    for (const Triangle &triangle : scene.triangles) {
        if (is_dielectric(scene, triangle.material)) {
            if (places.empty()) {
                places = places_of(scene.vertices);
            }
            for (std::size_t i = 0; i < 3; ++i) {
                const auto [low, high] = std::minmax(places[triangle.vertices[i]],
                                                     places[triangle.vertices[(i + 1) % 3]]);
                edges.push_back({triangle.mesh, low, high});
            }
        }
    }
    std::ranges::sort(edges);
    return edges;
}

}  // namespace

std::vector<std::string> open_dielectric_meshes(const Scene &scene) {
    std::vector<std::size_t> faults(scene.meshes.size());
    const std::vector<Edge> edges = dielectric_edges(scene);
    for (auto edge = edges.begin(); edge != edges.end();) {
        const auto next = std::upper_bound(edge, edges.end(), *edge);
        faults[static_cast<std::size_t>(edge->mesh)] += (next - edge) % 2 == 0 ? 0 : 1;
        edge = next;
    }
    std::vector<std::string> lines;
    for (std::size_t i = 0; i < faults.size(); ++i) {
        if (faults[i] > 0) {
            lines.push_back(fmt::format(
                "{}: {} is a dielectric but not closed: {} of its edges have not just two "
                "triangles, and what slips through there is absorbed by no law",
                to_string(scene.meshes[i].where), scene.meshes[i].file.string(), faults[i]));
        }
    }
    return lines;
}

}  // namespace stagelight
