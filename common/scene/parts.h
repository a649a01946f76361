// SPDX-License-Identifier: MIT
// The connected parts of a mesh, what they enclose, and which lies inside which.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scene/box_tree.h"
#include "scene/edge_graph.h"
#include "scene/scene.h"

namespace stagelight {

struct Part {
    std::vector<std::uint32_t> triangles;  // indices into Scene::triangles, ascending
    Box box;
    bool is_closed = true;
    // Signed: positive where the order of the corners says that the outside is outside. That of a
    // part with holes is what it would be if each were closed by a flat lid.
    double volume = 0;
    // Closed, or nearly: a sheet, a bowl or the surface of a lake has no inside.
    bool has_inside = true;
};

// `graph` is that of `triangles`, indices into Scene::triangles, ascending.
std::vector<Part> parts_of(const Scene &scene, std::span<const std::uint32_t> triangles,
                           const EdgeGraph &graph);

constexpr int no_part = -1;

// For each part the smallest other that it lies in, or no_part. The parts are of one mesh.
std::vector<int> enclosing_parts(const Scene &scene, const std::vector<Part> &parts);

}  // namespace stagelight
