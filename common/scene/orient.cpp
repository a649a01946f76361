// SPDX-License-Identifier: MIT
#include "scene/orient.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numeric>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "scene/dielectrics.h"
#include "scene/doubled_faces.h"
#include "scene/edge_graph.h"
#include "scene/errors.h"
#include "scene/outward_normals.h"
#include "scene/parts.h"
#include "scene/places.h"
#include "scene/smooth_turned.h"

namespace stagelight {
namespace {

// Of the triangles of a mesh, those to turn so that neighbours agree: of each piece that can be
// walked over its edges, the lesser part. And the number of edges where they do not agree even so.
struct Agreement {
    std::vector<bool> turned;
    std::size_t conflicts = 0;
};

Agreement agree(const EdgeGraph &graph) {
    Agreement found{std::vector<bool>(graph.across.size())};
    std::vector<bool> reached(graph.across.size());
    std::vector<std::uint32_t> piece;  // those before `next` have told their neighbours
    for (std::uint32_t seed = 0; seed < graph.across.size(); ++seed) {
        if (reached[seed]) {
            continue;
        }
        reached[seed] = true;
        piece.assign(1, seed);
        std::size_t turned = 0;
        for (std::size_t next = 0; next < piece.size(); ++next) {
            const std::uint32_t triangle = piece[next];
            turned += found.turned[triangle] ? 1 : 0;
            for (const EdgeGraph::Neighbour &neighbour : graph.across[triangle]) {
                if (neighbour.triangle == EdgeGraph::none) {
                    continue;
                }
                const bool turn = found.turned[triangle] == neighbour.agrees;
                if (!reached[neighbour.triangle]) {
                    reached[neighbour.triangle] = true;
                    found.turned[neighbour.triangle] = turn;
                    piece.push_back(neighbour.triangle);
                } else if (found.turned[neighbour.triangle] != turn
                           && neighbour.triangle > triangle) {  // each edge once
                    ++found.conflicts;
                }
            }
        }
        if (2 * turned > piece.size()) {
            for (const std::uint32_t triangle : piece) {
                found.turned[triangle] = !found.turned[triangle];
            }
        }
    }
    return found;
}

// Those whose volume has the wrong sign: outwards is right, but for the wall of a cavity, which the
// file has wound the other way round than what is around it.
std::vector<bool> wrong_way_round(const Scene &scene, const std::vector<Part> &parts) {
    const std::vector<int> enclosing = enclosing_parts(scene, parts);
    std::vector<std::size_t> from_outside(parts.size());
    std::iota(from_outside.begin(), from_outside.end(), std::size_t{0});
    std::ranges::stable_sort(from_outside, std::greater<>(),
                             [&](std::size_t i) { return std::abs(parts[i].volume); });
    std::vector<bool> wrong(parts.size());
    for (const std::size_t i : from_outside) {
        const bool is_outwards = parts[i].volume > 0;
        bool should_be = true;
        if (enclosing[i] != no_part) {
            const auto outer = static_cast<std::size_t>(enclosing[i]);
            const bool outer_was = parts[outer].volume > 0;
            should_be = is_outwards == outer_was || outer_was == wrong[outer];
        }
        wrong[i] = parts[i].has_inside && is_outwards != should_be;
    }
    return wrong;
}

void turn(Scene &scene, std::span<const std::uint32_t> triangles, std::vector<bool> &turned) {
    for (const std::uint32_t triangle : triangles) {
        std::swap(scene.triangles[triangle].vertices[1], scene.triangles[triangle].vertices[2]);
        turned[triangle] = !turned[triangle];
    }
}

// The number of edges where no way round is right.
std::size_t orient(Scene &scene, std::vector<std::uint32_t> &places,
                   std::span<const std::uint32_t> triangles) {
    const EdgeGraph graph = edge_graph(scene, places, triangles);
    const Agreement agreement = agree(graph);
    std::vector<bool> turned(scene.triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        if (agreement.turned[i]) {
            turn(scene, triangles.subspan(i, 1), turned);
        }
    }
    const std::vector<Part> parts = parts_of(scene, triangles, graph);
    const std::vector<bool> wrong = wrong_way_round(scene, parts);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (wrong[i]) {
            turn(scene, parts[i].triangles, turned);
        }
    }
    point_normals_outwards(scene, places, parts, turned);
    for (const Part &part : parts) {
        smooth_turned(scene, places, part, turned);
    }
    return agreement.conflicts + graph.crowded;
}

}  // namespace

std::vector<std::string> orient_dielectrics(Scene &scene) {
    std::vector<std::string> lines;
    drop_doubled_faces(scene);
    std::vector<std::uint32_t> places;
    const auto of_mesh = dielectric_triangles(scene);
    for (std::size_t i = 0; i < of_mesh.size(); ++i) {
        if (of_mesh[i].empty()) {
            continue;
        }
        if (places.empty()) {
            places = places_of(scene.vertices);
        }
        if (const std::size_t edges = orient(scene, places, of_mesh[i]); edges > 0) {
            lines.push_back(fmt::format(
                "{}: {} is a dielectric without a clear outside: at {} of its edges the triangles "
                "can't all face the same way, as on a Möbius strip or where three of them meet; "
                "near them a ray may take glass for air",
                to_string(scene.meshes[i].where), scene.meshes[i].file.string(), edges));
        }
    }
    return lines;
}

}  // namespace stagelight
