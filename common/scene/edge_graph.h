// SPDX-License-Identifier: MIT
// Which triangles of a mesh are neighbours.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "scene/scene.h"

namespace stagelight {

// Of a list of triangles; all indices here are into that list. Edge i of a triangle runs from its
// corner i to the next.
struct EdgeGraph {
    static constexpr std::uint32_t none = ~std::uint32_t{0};
    struct Neighbour {
        std::uint32_t triangle = none;
        bool agrees = false;  // it runs along the edge the other way, as on one side of a surface
    };

    std::vector<std::array<Neighbour, 3>> across;  // of each triangle, over each edge

    // An edge of three, five, … triangles tells no two of them from the rest: each has no
    // neighbour there.
    std::size_t crowded = 0;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> crowded_links;  // they are still one piece
};

// Edges are told by the places of their ends (places_of), so the seams of normals and texture
// coordinates don't matter. Where four or more triangles meet in pairs, as where two cubes touch,
// neighbours are those that enclose glass between them.
EdgeGraph edge_graph(const Scene &scene, const std::vector<std::uint32_t> &places,
                     std::span<const std::uint32_t> triangles);

// For each triangle of the list the number of the connected part it belongs to, from 0 on, in the
// order of their first triangles.
std::vector<std::uint32_t> connected_parts(const EdgeGraph &graph);

}  // namespace stagelight
