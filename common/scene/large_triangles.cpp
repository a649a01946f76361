// SPDX-License-Identifier: MIT
#include "scene/large_triangles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "scene/box_tree.h"
#include "scene/disjoint_sets.h"
#include "scene/places.h"

namespace stagelight {
namespace {

constexpr double largest_ratio = 24;

double longest_edge(const Scene &scene, const Triangle &triangle) {
    double longest = 0;  // squared
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 edge = scene.vertices[triangle.vertices[i]].position
                                - scene.vertices[triangle.vertices[(i + 1) % 3]].position;
        longest = std::max(longest, glm::dot(edge, edge));
    }
    return std::sqrt(longest);
}

// What must be seen well: a box around it, and how large it is.
struct Object {
    Box box;
    double size = 0;
    int part = -1;  // of the meshes' connected parts; a part does not cut itself
};

// The triangle's places become one part.
void join_corners(std::vector<std::uint32_t> &root, const std::vector<std::uint32_t> &places,
                  const Triangle &triangle) {
    for (const std::size_t corner : {1U, 2U}) {
        join(root, places[triangle.vertices[0]], places[triangle.vertices[corner]]);
    }
}

// The connected parts of all meshes, by the positions that their triangles share.
std::vector<std::uint32_t> parts_of_triangles(const Scene &scene) {
    const std::vector<std::uint32_t> places = places_of(scene.vertices);
    std::vector<std::uint32_t> root(places.size());
    std::iota(root.begin(), root.end(), 0u);
    for (const Triangle &triangle : scene.triangles) {
        join_corners(root, places, triangle);
    }
    std::vector<std::uint32_t> parts;
    for (const Triangle &triangle : scene.triangles) {
        parts.push_back(root_of(root, places[triangle.vertices[0]]));
    }
    return parts;
}

std::vector<Object> objects_of(const Scene &scene, const std::vector<std::uint32_t> &parts) {
    std::vector<Object> objects;
    for (const Sphere &sphere : scene.spheres) {
        objects.push_back(
            {Box{sphere.center, sphere.center}.padded(sphere.radius), 2 * sphere.radius, -1});
    }
    std::map<std::uint32_t, Box> boxes;
    for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
        for (const std::uint32_t vertex : scene.triangles[i].vertices) {
            boxes[parts[i]].add(scene.vertices[vertex].position);
        }
    }
    for (const auto &[part, box] : boxes) {
        objects.push_back({box, glm::length(box.high - box.low), static_cast<int>(part)});
    }
    const double smallest = std::ranges::min(objects, {}, &Object::size).size;
    Box eye;
    eye.add(scene.camera.position);
    objects.push_back({eye, smallest, -1});
    return objects;
}

// From the triangle's plane and box: no more than to the triangle itself.
double distance_to(const Scene &scene, const Triangle &triangle, const Box &box) {
    const auto &[a, b, c] = triangle.vertices;
    Box own;
    for (const std::uint32_t vertex : triangle.vertices) {
        own.add(scene.vertices[vertex].position);
    }
    const glm::dvec3 gap =
        glm::max(glm::max(own.low - box.high, box.low - own.high), glm::dvec3(0));
    const glm::dvec3 corner = scene.vertices[a].position;
    const glm::dvec3 across =
        glm::cross(scene.vertices[b].position - corner, scene.vertices[c].position - corner);
    const double area = glm::length(across);
    const glm::dvec3 half = 0.5 * (box.high - box.low);
    const double to_plane =
        area > 0
            ? (std::abs(glm::dot(across, box.center() - corner)) - glm::dot(glm::abs(across), half))
                  / area
            : 0;
    return std::max(glm::length(gap), to_plane);
}

class Cutter {
public:
    explicit Cutter(Scene &scene)
        : scene_(scene), parts_(parts_of_triangles(scene)), objects_(objects_of(scene, parts_)) {}

    void cut() {
        for (std::size_t i = 0; i < scene_.triangles.size(); ++i) {
            while (is_too_large(i)) {
                if (beside_.empty()) {  // few scenes come here
                    add_all_edges();
                }
                halve(i);
            }
        }
    }

private:
    using Position = std::array<double, 3>;
    using Edge = std::pair<Position, Position>;  // its ends, the lesser first

    const Vertex &corner(std::size_t triangle, std::size_t i) const {
        return scene_.vertices[scene_.triangles[triangle].vertices[i % 3]];
    }

    Edge edge(std::size_t triangle, std::size_t i) const {
        const glm::dvec3 &a = corner(triangle, i).position, &b = corner(triangle, i + 1).position;
        const Position one{a.x, a.y, a.z}, other{b.x, b.y, b.z};
        return std::minmax(one, other);
    }

    // The same for all triangles that share it.
    std::size_t longest(std::size_t triangle) const {
        const auto key = [&](std::size_t i) {
            return std::pair(
                glm::distance(corner(triangle, i).position, corner(triangle, i + 1).position),
                edge(triangle, i));
        };
        std::size_t found = 0;
        for (const std::size_t i : {1U, 2U}) {
            found = key(i) > key(found) ? i : found;
        }
        return found;
    }

    bool is_too_large(std::size_t triangle) const {
        const double size = longest_edge(scene_, scene_.triangles[triangle]);
        return std::ranges::any_of(objects_, [&](const Object &object) {
            return object.part != static_cast<int>(parts_[triangle])
                   && size > largest_ratio * object.size
                   && size > largest_ratio
                                 * distance_to(scene_, scene_.triangles[triangle], object.box);
        });
    }

    void add_all_edges() {
        for (std::size_t i = 0; i < scene_.triangles.size(); ++i) {
            add_edges(i);
        }
    }

    void add_edges(std::size_t triangle) {
        for (const std::size_t i : {0U, 1U, 2U}) {
            beside_[edge(triangle, i)].insert(triangle);
        }
    }

    void remove_edges(std::size_t triangle) {
        for (const std::size_t i : {0U, 1U, 2U}) {
            beside_[edge(triangle, i)].erase(triangle);
        }
    }

    // At the middle of its longest edge, with all that share it: those of which it is not the
    // longest are halved before, until it is.
    void halve(std::size_t triangle) {
        const Edge cut = edge(triangle, longest(triangle));
        for (bool all = false; !all;) {
            all = true;
            for (const std::size_t other : std::set(beside_[cut])) {
                if (edge(other, longest(other)) != cut) {
                    halve(other);
                    all = false;
                    break;
                }
            }
        }
        for (const std::size_t each : std::set(beside_[cut])) {
            split(each, longest(each));
        }
    }

    void split(std::size_t triangle, std::size_t i) {
        remove_edges(triangle);
        Triangle first = scene_.triangles[triangle], second = first;
        const std::uint32_t middle = middle_of(first.vertices[i], first.vertices[(i + 1) % 3]);
        first.vertices[(i + 1) % 3] = middle;
        second.vertices[i] = middle;
        scene_.triangles[triangle] = first;
        scene_.triangles.push_back(second);
        parts_.push_back(parts_[triangle]);
        add_edges(triangle);
        add_edges(scene_.triangles.size() - 1);
    }

    std::uint32_t middle_of(std::uint32_t one, std::uint32_t other) {
        const auto [place, is_new] = middles_.try_emplace(
            std::minmax(one, other), static_cast<std::uint32_t>(scene_.vertices.size()));
        if (is_new) {
            const Vertex &a = scene_.vertices[one], &b = scene_.vertices[other];
            scene_.vertices.push_back({0.5 * (a.position + b.position),
                                       0.5 * (a.normal + b.normal),  // as long as it comes
                                       0.5 * (a.texture_coordinates + b.texture_coordinates),
                                       0.5 * (a.color + b.color)});
        }
        return place->second;
    }

    Scene &scene_;
    std::vector<std::uint32_t> parts_;  // of each triangle
    std::vector<Object> objects_;
    std::map<Edge, std::set<std::size_t>> beside_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles_;
};

// Removes those of `triangles` that hang together with one at a marked place, and marks their
// places; `place` is a vertex's. A few times along the order of the file do.
void drop_marked(const Scene &scene, std::vector<std::uint32_t> &triangles,
                 std::vector<char> &marks, const auto &place) {
    for (std::size_t left = triangles.size() + 1; triangles.size() < left;) {
        left = triangles.size();
        std::erase_if(triangles, [&](std::uint32_t triangle) {
            const auto &[a, b, c] = scene.triangles[triangle].vertices;
            const bool is_marked = (marks[place(a)] | marks[place(b)] | marks[place(c)]) != 0;
            if (is_marked) {
                marks[place(a)] = marks[place(b)] = marks[place(c)] = 1;
            }
            return is_marked;
        });
        std::ranges::reverse(triangles);
    }
}

// The diagonal of the smallest connected part, if all triangles of one are smaller than `size`;
// else infinity.
double smallest_part(const Scene &scene, const std::vector<double> &sizes, double size) {
    std::vector<char> at_vertex(scene.vertices.size());
    std::vector<std::uint32_t> smaller;
    for (std::uint32_t i = 0; i < sizes.size(); ++i) {
        if (sizes[i] >= size) {
            const auto &[a, b, c] = scene.triangles[i].vertices;
            at_vertex[a] = at_vertex[b] = at_vertex[c] = 1;
        } else {
            smaller.push_back(i);
        }
    }
    // By vertices first: to know which are at the same position takes longer.
    drop_marked(scene, smaller, at_vertex, [](std::uint32_t vertex) { return vertex; });
    double smallest = std::numeric_limits<double>::infinity();
    if (smaller.empty()) {
        return smallest;
    }
    const std::vector<std::uint32_t> places = places_of(scene.vertices);
    std::vector<char> at_place(places.size());
    for (std::size_t vertex = 0; vertex < places.size(); ++vertex) {
        at_place[places[vertex]] = static_cast<char>(at_place[places[vertex]] | at_vertex[vertex]);
    }
    drop_marked(scene, smaller, at_place, [&](std::uint32_t vertex) { return places[vertex]; });
    std::vector<std::uint32_t> root(places.size());
    std::iota(root.begin(), root.end(), 0U);
    for (const std::uint32_t triangle : smaller) {
        join_corners(root, places, scene.triangles[triangle]);
    }
    std::map<std::uint32_t, Box> parts;
    for (const std::uint32_t triangle : smaller) {
        for (const std::uint32_t vertex : scene.triangles[triangle].vertices) {
            parts[root_of(root, places[vertex])].add(scene.vertices[vertex].position);
        }
    }
    for (const auto &[place, box] : parts) {
        smallest = std::min(smallest, glm::length(box.high - box.low));
    }
    return smallest;
}

// Whether a triangle can be too large for anything: most scenes are through here.
bool may_need_cuts(const Scene &scene) {
    std::vector<double> sizes;
    sizes.reserve(scene.triangles.size());
    double largest = 0;
    for (const Triangle &triangle : scene.triangles) {
        sizes.push_back(longest_edge(scene, triangle));
        largest = std::max(largest, sizes.back());
    }
    double smallest = smallest_part(scene, sizes, largest / largest_ratio);
    for (const Sphere &sphere : scene.spheres) {
        smallest = std::min(smallest, 2 * sphere.radius);
    }
    return largest > largest_ratio * smallest;
}

}  // namespace

void cut_large_triangles(Scene &scene) {
    if (may_need_cuts(scene)) {
        Cutter(scene).cut();
    }
}

}  // namespace stagelight
