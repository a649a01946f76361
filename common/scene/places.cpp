// SPDX-License-Identifier: MIT
#include "scene/places.h"

#include <bit>
#include <cstddef>

namespace stagelight {
namespace {

constexpr std::uint32_t none = ~std::uint32_t{0};

std::size_t hash_of(const glm::dvec3 &position) {
    std::size_t hash = 0;
    for (const double value : {position.x, position.y, position.z}) {
        hash = (hash ^ std::bit_cast<std::uint64_t>(value + 0.0)) * 0x9e3779b97f4a7c15;  // no -0
        hash ^= hash >> 32;
    }
    return hash;
}

}  // namespace

// A hash table with open addressing: sorting would take four times as long.
std::vector<std::uint32_t> places_of(const std::vector<Vertex> &vertices) {
    std::vector<std::uint32_t> table(std::bit_ceil(2 * vertices.size() + 1), none);
    std::vector<std::uint32_t> places(vertices.size());
    std::uint32_t count = 0;
    for (std::uint32_t i = 0; i < vertices.size(); ++i) {
        const glm::dvec3 &position = vertices[i].position;
        std::size_t at = hash_of(position) & (table.size() - 1);
        while (table[at] != none && vertices[table[at]].position != position) {
            at = (at + 1) & (table.size() - 1);
        }
        if (table[at] == none) {
            table[at] = i;
            places[i] = count++;
        } else {
            places[i] = places[table[at]];
        }
    }
    return places;
}

}  // namespace stagelight
