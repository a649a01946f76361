// SPDX-License-Identifier: MIT
#include "scene/parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>

#include <glm/geometric.hpp>

#include "scene/mesh_surface.h"

namespace stagelight {
namespace {

void measure(const Scene &scene, Part &part, const glm::dvec3 &origin) {
    glm::dvec3 facing(0);
    double size = 0;
    for (const std::uint32_t index : part.triangles) {
        const auto [a, b, c] = corners_of(scene, scene.triangles[index]);
        const glm::dvec3 area = 0.5 * glm::cross(b - a, c - a);
        part.volume += glm::dot(a - origin, area) / 3;
        facing += area;
        size += glm::length(area);
    }
    // The areas of a closed surface add up to zero, and else to those of its lids.
    const glm::dvec3 extent = part.box.high - part.box.low;
    part.has_inside =
        (part.is_closed || glm::length(facing) < 0.1 * size)
        && std::abs(part.volume) > 1e-9 * glm::dot(extent, extent) * glm::length(extent);
}

}  // namespace

std::vector<Part> parts_of(const Scene &scene, std::span<const std::uint32_t> triangles,
                           const EdgeGraph &graph) {
    const std::vector<std::uint32_t> numbers = connected_parts(graph);
    std::vector<Part> parts;
    struct Rim {
        glm::dvec3 sum{0};
        double count = 0;
    };
    std::vector<Rim> rims;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        if (numbers[i] == parts.size()) {
            parts.emplace_back();
            rims.emplace_back();
        }
        Part &part = parts[numbers[i]];
        part.triangles.push_back(triangles[i]);
        const TriangleCorners corners = corners_of(scene, scene.triangles[triangles[i]]);
        part.box.add(box_of(corners));
        for (std::size_t edge = 0; edge < 3; ++edge) {
            if (graph.across[i][edge].triangle == EdgeGraph::none) {
                part.is_closed = false;
                rims[numbers[i]].sum += corners[edge] + corners[(edge + 1) % 3];
                rims[numbers[i]].count += 2;
            }
        }
    }
    for (std::size_t i = 0; i < parts.size(); ++i) {
        // Seen from within its lid, that adds nothing.
        measure(scene, parts[i],
                parts[i].is_closed ? parts[i].box.center() : rims[i].sum / rims[i].count);
    }
    return parts;
}

std::vector<int> enclosing_parts(const Scene &scene, const std::vector<Part> &parts) {
    std::vector<Box> boxes;
    boxes.reserve(parts.size());
    for (const Part &part : parts) {
        boxes.push_back(part.box);
    }
    const BoxTree tree(boxes);
    std::vector<std::optional<MeshSurface>> surfaces(parts.size());
    const auto encloses = [&](std::size_t outer, const Part &inner) {
        if (!surfaces[outer]) {
            surfaces[outer].emplace(scene, parts[outer].triangles);
        }
        // Three points, since one may lie where the two touch.
        int inside = 0;
        for (const std::size_t at :
             {std::size_t{0}, inner.triangles.size() / 2, inner.triangles.size() - 1}) {
            const auto [a, b, c] = corners_of(scene, scene.triangles[inner.triangles[at]]);
            inside += std::abs(surfaces[outer]->winding_number((a + b + c) / 3.0)) > 0.5 ? 1 : 0;
        }
        return inside >= 2;
    };
    std::vector<int> enclosing(parts.size(), no_part);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        tree.each(parts[i].box, [&](std::uint32_t other) {
            const double volume = std::abs(parts[other].volume);
            const int known = enclosing[i];
            if (other != i && parts[other].has_inside && parts[other].box.contains(parts[i].box)
                && volume > std::abs(parts[i].volume)
                && (known == no_part
                    || volume < std::abs(parts[static_cast<std::size_t>(known)].volume))
                && encloses(other, parts[i])) {
                enclosing[i] = static_cast<int>(other);
            }
        });
    }
    return enclosing;
}

}  // namespace stagelight
