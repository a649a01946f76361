// SPDX-License-Identifier: MIT
#include "scene/places.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <tuple>

namespace stagelight {

std::vector<std::uint32_t> places_of(const std::vector<Vertex> &vertices) {
    const auto position = [&vertices](std::uint32_t vertex) {
        const glm::dvec3 &p = vertices[vertex].position;
        return std::tie(p.x, p.y, p.z);
    };
    std::vector<std::uint32_t> order(vertices.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::sort(order, {}, position);
    std::vector<std::uint32_t> places(vertices.size());
    for (std::size_t i = 1; i < order.size(); ++i) {
        places[order[i]] =
            places[order[i - 1]] + (position(order[i]) == position(order[i - 1]) ? 0 : 1);
    }
    return places;
}

}  // namespace stagelight
