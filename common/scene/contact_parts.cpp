// SPDX-License-Identifier: MIT
#include "scene/contact_parts.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "scene/dielectrics.h"
#include "scene/disjoint_sets.h"
#include "scene/edge_graph.h"
#include "scene/mesh_surface.h"
#include "scene/places.h"

namespace stagelight {
namespace {

constexpr std::uint32_t none = ~std::uint32_t{0};

}  // namespace

ContactParts::ContactParts(const Scene &scene)
    : scene_(scene), places_(places_of(scene.vertices)), parts_(scene.triangles.size()) {
    std::vector<std::uint32_t> root(scene.triangles.size());
    std::iota(root.begin(), root.end(), 0u);
    std::vector<std::uint32_t> last_at(scene.vertices.size(), none);  // of each place
    for (std::uint32_t i = 0; i < scene.triangles.size(); ++i) {
        const Triangle &triangle = scene.triangles[i];
        if (is_dielectric(scene, triangle.material)) {
            continue;
        }
        for (const std::uint32_t vertex : triangle.vertices) {
            std::uint32_t &last = last_at[places_[vertex]];
            if (last != none && scene.triangles[last].mesh == triangle.mesh) {
                join(root, last, i);
            }
            last = i;
        }
    }
    for (const std::vector<std::uint32_t> &triangles : dielectric_triangles(scene)) {
        const auto numbers = connected_parts(edge_graph(scene, places_, triangles));
        std::vector<std::uint32_t> first;
        for (std::size_t i = 0; i < triangles.size(); ++i) {
            if (numbers[i] == first.size()) {
                first.push_back(triangles[i]);
            }
            join(root, first[numbers[i]], triangles[i]);
        }
    }
    number_parts(root);
}

void ContactParts::number_parts(std::vector<std::uint32_t> &root) {
    std::vector<int> material;
    for (std::uint32_t i = 0; i < parts_.size(); ++i) {
        const std::uint32_t first = root_of(root, i);
        if (first == i) {
            parts_[i] = static_cast<std::uint32_t>(boxes_.size());
            boxes_.emplace_back();
            several_materials_.push_back(false);
            material.push_back(scene_.triangles[i].material);
        }
        const std::uint32_t part = parts_[i] = parts_[first];
        boxes_[part].add(box_of(corners_of(scene_, scene_.triangles[i])));
        if (scene_.triangles[i].material != material[part]) {
            several_materials_[part] = true;
        }
    }
    sort_by_part();
    closed_.resize(boxes_.size());
    for (std::uint32_t i = 0; i < parts_.size(); ++i) {
        if (several_materials_[parts_[i]]) {
            first_of_material_.emplace(std::pair(parts_[i], scene_.triangles[i].material), i);
        }
    }
}

void ContactParts::sort_by_part() {
    first_of_.resize(boxes_.size() + 1);
    for (const std::uint32_t part : parts_) {
        ++first_of_[part + 1];
    }
    std::partial_sum(first_of_.begin(), first_of_.end(), first_of_.begin());
    by_part_.resize(parts_.size());
    std::vector<std::uint32_t> next = first_of_;
    for (std::uint32_t i = 0; i < parts_.size(); ++i) {
        by_part_[next[parts_[i]]++] = i;
    }
}

std::uint32_t ContactParts::first_of_material(std::uint32_t triangle) const {
    const std::uint32_t part = parts_[triangle];
    return several_materials_[part]
               ? first_of_material_.at({part, scene_.triangles[triangle].material})
               : 0;
}

bool ContactParts::is_closed(std::uint32_t part) const {
    if (!closed_[part]) {
        std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
        for (const std::uint32_t i : triangles(part)) {
            for (std::size_t edge = 0; edge < 3; ++edge) {
                const auto &vertices = scene_.triangles[i].vertices;
                edges.emplace_back(
                    std::minmax(places_[vertices[edge]], places_[vertices[(edge + 1) % 3]]));
            }
        }
        std::ranges::sort(edges);
        bool is_closed = true;
        for (auto edge = edges.begin(); edge != edges.end();) {
            const auto next = std::upper_bound(edge, edges.end(), *edge);
            is_closed = is_closed && (next - edge) % 2 == 0;
            edge = next;
        }
        closed_[part] = is_closed;
    }
    return *closed_[part];
}

}  // namespace stagelight
