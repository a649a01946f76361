// SPDX-License-Identifier: MIT
#include "scene/bodies.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <set>
#include <tuple>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "scene/body_relation.h"
#include "scene/dielectrics.h"
#include "scene/edge_graph.h"
#include "scene/errors.h"
#include "scene/parts.h"
#include "scene/places.h"
#include "scene/rounding.h"

namespace stagelight {
namespace {

// A part and the cavities in it are one body. `triangles` are the dielectric ones of a mesh.
void append_mesh(std::vector<Body> &list, const Scene &scene, std::size_t mesh,
                 const std::vector<std::uint32_t> &places,
                 const std::vector<std::uint32_t> &triangles) {
    const std::vector<Part> parts =
        parts_of(scene, triangles, edge_graph(scene, places, triangles));
    const std::vector<int> enclosing = enclosing_parts(scene, parts);
    const auto is_cavity = [&](std::size_t part) {
        return parts[part].has_inside && parts[part].volume < 0 && enclosing[part] != no_part;
    };
    std::vector<std::size_t> body_of(parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (!is_cavity(i)) {
            body_of[i] = list.size();
            list.push_back({.material = scene.triangles[parts[i].triangles.front()].material,
                            .where = scene.meshes[mesh].where});
        }
    }
    for (std::size_t i = 0; i < parts.size(); ++i) {
        Body &body = list[body_of[is_cavity(i) ? static_cast<std::size_t>(enclosing[i]) : i]];
        body.volume += parts[i].volume;
        body.shells.push_back(parts[i].triangles.front());
        body.is_closed = body.is_closed && parts[i].is_closed;
        body.triangles.insert(body.triangles.end(), parts[i].triangles.begin(),
                              parts[i].triangles.end());
    }
}

std::vector<Body> in_file_order(const Scene &scene) {
    std::vector<Body> list;
    for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
        const Sphere &sphere = scene.spheres[i];
        if (is_dielectric(scene, sphere.material)) {
            list.push_back({.material = sphere.material,
                            .volume = 4.0 / 3 * std::numbers::pi * std::pow(sphere.radius, 3),
                            .where = sphere.where,
                            .sphere = static_cast<int>(i)});
        }
    }
    for (std::size_t i = 0; i < scene.planes.size(); ++i) {
        const Plane &plane = scene.planes[i];
        if (is_dielectric(scene, plane.material)) {
            list.push_back({.material = plane.material,
                            .volume = std::numeric_limits<double>::infinity(),
                            .where = plane.where,
                            .plane = static_cast<int>(i)});
        }
    }
    std::vector<std::uint32_t> places;
    const auto of_mesh = dielectric_triangles(scene);
    for (std::size_t i = 0; i < of_mesh.size(); ++i) {
        if (!of_mesh[i].empty()) {
            if (places.empty()) {
                places = places_of(scene.vertices);
            }
            append_mesh(list, scene, i, places, of_mesh[i]);
        }
    }
    for (Body &body : list) {
        body.volume = std::abs(body.volume);
        std::ranges::sort(body.triangles);
    }
    std::ranges::stable_sort(
        list, {}, [](const Body &body) { return std::pair(body.where.line, body.where.column); });
    return list;
}

// Of two equal cubes neither is the smaller one, wherever they stand and however that was rounded.
double rough(double volume) {
    const int exponent = std::ilogb(volume);
    return std::isfinite(volume) && volume > 0
               ? std::ldexp(std::round(std::ldexp(volume, 16 - exponent)), exponent - 16)
               : volume;
}

void tell_shapes(Bodies &bodies, const Scene &scene) {
    bodies.of_sphere.assign(scene.spheres.size(), -1);
    bodies.of_plane.assign(scene.planes.size(), -1);
    bodies.of_triangle.assign(scene.triangles.size(), -1);
    for (std::size_t i = 0; i < bodies.list.size(); ++i) {
        const Body &body = bodies.list[i];
        const int index = static_cast<int>(i);
        if (body.sphere >= 0) {
            bodies.of_sphere[static_cast<std::size_t>(body.sphere)] = index;
        }
        if (body.plane >= 0) {
            bodies.of_plane[static_cast<std::size_t>(body.plane)] = index;
        }
        for (const std::uint32_t triangle : body.triangles) {
            bodies.of_triangle[triangle] = index;
        }
    }
}

// Pairs that may meet, the lesser index first.
std::vector<std::pair<int, int>> neighbours(const BodyRelations &relations, std::size_t count) {
    std::vector<std::pair<int, int>> pairs;
    std::vector<Box> boxes;
    std::vector<int> bounded;
    for (std::size_t i = 0; i < count; ++i) {
        const int index = static_cast<int>(i);
        if (const std::optional<Box> &box = relations.box(i)) {
            boxes.push_back(box->padded(touching * largest_coordinate(*box)));
            bounded.push_back(index);
        } else {
            for (int other = 0; other < static_cast<int>(count); ++other) {
                if (relations.box(static_cast<std::size_t>(other)) || other < index) {
                    pairs.emplace_back(std::minmax(index, other));
                }
            }
        }
    }
    const BoxTree tree(boxes);
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        tree.each(boxes[i], [&](std::uint32_t other) {
            if (other < i) {
                pairs.emplace_back(bounded[other], bounded[i]);
            }
        });
    }
    std::ranges::sort(pairs);
    return pairs;
}

}  // namespace

Bodies bodies_of(const Scene &scene) {
    Bodies bodies;
    bodies.list = in_file_order(scene);
    const auto priority = [&](const Body &body) {
        return scene.materials[static_cast<std::size_t>(body.material)].priority;
    };
    std::ranges::stable_sort(bodies.list, {}, [&](const Body &body) {
        return std::pair(priority(body), -rough(body.volume));
    });
    tell_shapes(bodies, scene);
    const BodyRelations relations(scene, bodies.list);
    std::set<std::string> told;
    for (const auto &pair : neighbours(relations, bodies.list.size())) {
        const auto [low, high] = pair;
        const Relation relation =
            relations.of(static_cast<std::size_t>(low), static_cast<std::size_t>(high));
        if (relation == Relation::apart) {
            continue;
        }
        bodies.meeting.push_back(pair);
        const Body &hidden = bodies.list[static_cast<std::size_t>(low)];
        const Body &around = bodies.list[static_cast<std::size_t>(high)];
        if (relation == Relation::first_in_second) {
            std::string line = fmt::format(
                "{}: this dielectric has priority {} and lies wholly inside the one at {}, which "
                "has priority {}, so it can't be seen; give it a higher priority",
                to_string(hidden.where), priority(hidden), to_string(around.where),
                priority(around));
            if (told.insert(line).second) {
                bodies.warnings.push_back(std::move(line));
            }
        }
    }
    return bodies;
}

}  // namespace stagelight
