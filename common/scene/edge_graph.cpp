// SPDX-License-Identifier: MIT
#include "scene/edge_graph.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <glm/geometric.hpp>

#include "scene/normalize.h"

namespace stagelight {
namespace {

// A triangle's side of an edge.
struct Side {
    std::uint32_t triangle;
    std::uint32_t edge;
    bool goes_up;      // the triangle runs from the lower place to the higher
    double angle = 0;  // of the triangle about the edge
};

struct Key {
    std::uint64_t places;  // of its ends, the lower one first
    std::uint32_t side;    // three a triangle
};

std::vector<Key> sorted_sides(const Scene &scene, const std::vector<std::uint32_t> &places,
                              std::span<const std::uint32_t> triangles) {
    std::vector<Key> sides;
    sides.reserve(3 * triangles.size());
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        const auto &vertices = scene.triangles[triangles[i]].vertices;
        for (std::uint32_t edge = 0; edge < 3; ++edge) {
            const auto [low, high] =
                std::minmax(places[vertices[edge]], places[vertices[(edge + 1) % 3]]);
            sides.push_back({std::uint64_t{low} << 32 | high, 3 * i + edge});
        }
    }
    std::ranges::sort(sides, {}, [](const Key &key) { return std::tie(key.places, key.side); });
    return sides;
}

void join(EdgeGraph &graph, const Side &a, const Side &b) {
    const bool agrees = a.goes_up != b.goes_up;
    graph.across[a.triangle][a.edge] = {b.triangle, agrees};
    graph.across[b.triangle][b.edge] = {a.triangle, agrees};
}

// Sorts the sides of an edge by their angle about it.
void sort_around(const Scene &scene, std::span<const std::uint32_t> triangles,
                 std::span<Side> sides) {
    const auto position = [&](const Side &side, std::uint32_t corner) {
        const Triangle &triangle = scene.triangles[triangles[side.triangle]];
        return scene.vertices[triangle.vertices[(side.edge + corner) % 3]].position;
    };
    const Side &first = sides.front();
    const glm::dvec3 low = position(first, first.goes_up ? 0 : 1);
    const glm::dvec3 axis = normalize(position(first, first.goes_up ? 1 : 0) - low);
    const glm::dvec3 x = position(first, 2) - low;
    const glm::dvec3 y = glm::cross(axis, x);
    for (Side &side : sides) {
        const glm::dvec3 apex = position(side, 2) - low;
        side.angle = std::atan2(glm::dot(apex, y), glm::dot(apex - glm::dot(apex, axis) * axis, x));
    }
    std::ranges::stable_sort(sides, {}, &Side::angle);
}

bool coincide(const Side &a, const Side &b) {
    return std::abs(a.angle - b.angle) < 1e-9;
}

// How ill it would be to join each second side of these, from `start` on, with the next.
double cost(std::span<const Side> sides, std::size_t start) {
    double sum = 0;
    for (std::size_t i = start; i < start + sides.size(); i += 2) {
        const Side &a = sides[i % sides.size()], &b = sides[(i + 1) % sides.size()];
        sum += coincide(a, b) ? 1000.0 : 0.0;  // nothing lies between them
        sum += a.goes_up == b.goes_up ? 2.0 : 0.0;
        // A file tells one thing after the other.
        sum += 1e-12 * std::abs(double(a.triangle) - double(b.triangle));
    }
    return sum;
}

double least_cost(std::span<const Side> sides) {
    return std::min(cost(sides, 0), cost(sides, 1));
}

void join_around(EdgeGraph &graph, std::span<Side> sides) {
    for (std::size_t i = 1; i < sides.size(); ++i) {  // of two that coincide, either may be first
        if (coincide(sides[i - 1], sides[i])) {
            const double as_they_are = least_cost(sides);
            std::swap(sides[i - 1], sides[i]);
            if (as_they_are <= least_cost(sides)) {
                std::swap(sides[i - 1], sides[i]);
            }
        }
    }
    const std::size_t start = cost(sides, 0) <= cost(sides, 1) ? 0 : 1;
    for (std::size_t i = start; i < start + sides.size(); i += 2) {
        join(graph, sides[i % sides.size()], sides[(i + 1) % sides.size()]);
    }
}

}  // namespace

EdgeGraph edge_graph(const Scene &scene, const std::vector<std::uint32_t> &places,
                     std::span<const std::uint32_t> triangles) {
    EdgeGraph graph;
    graph.across.resize(triangles.size());
    const std::vector<Key> keys = sorted_sides(scene, places, triangles);
    std::vector<Side> edge;
    for (std::size_t i = 0; i < keys.size();) {
        const std::uint64_t ends = keys[i].places;
        edge.clear();
        for (; i < keys.size() && keys[i].places == ends; ++i) {
            const std::uint32_t triangle = keys[i].side / 3, number = keys[i].side % 3;
            const std::uint32_t from =
                places[scene.triangles[triangles[triangle]].vertices[number]];
            edge.push_back({.triangle = triangle, .edge = number, .goes_up = from == ends >> 32});
        }
        if (edge.size() == 2) {
            join(graph, edge[0], edge[1]);
        } else if (edge.size() % 2 == 0) {
            sort_around(scene, triangles, edge);
            join_around(graph, edge);
        } else if (edge.size() > 1) {
            ++graph.crowded;
            for (const Side &side : std::span(edge).subspan(1)) {
                graph.crowded_links.emplace_back(edge[0].triangle, side.triangle);
            }
        }
    }
    return graph;
}

std::vector<std::uint32_t> connected_parts(const EdgeGraph &graph) {
    std::vector<std::vector<std::uint32_t>> links(
        graph.crowded_links.empty() ? 0 : graph.across.size());
    for (const auto &[a, b] : graph.crowded_links) {
        links[a].push_back(b);
        links[b].push_back(a);
    }
    std::vector<std::uint32_t> parts(graph.across.size(), EdgeGraph::none);
    std::uint32_t count = 0;
    std::vector<std::uint32_t> open;
    const auto reach = [&](std::uint32_t triangle) {
        if (triangle != EdgeGraph::none && parts[triangle] == EdgeGraph::none) {
            parts[triangle] = count;
            open.push_back(triangle);
        }
    };
    for (std::uint32_t seed = 0; seed < parts.size(); ++seed) {
        if (parts[seed] != EdgeGraph::none) {
            continue;
        }
        reach(seed);
        while (!open.empty()) {
            const std::uint32_t triangle = open.back();
            open.pop_back();
            for (const EdgeGraph::Neighbour &neighbour : graph.across[triangle]) {
                reach(neighbour.triangle);
            }
            if (!links.empty()) {
                for (const std::uint32_t other : links[triangle]) {
                    reach(other);
                }
            }
        }
        ++count;
    }
    return parts;
}

}  // namespace stagelight
