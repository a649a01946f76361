// SPDX-License-Identifier: MIT
#include "scene/body_relation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "scene/rounding.h"

namespace stagelight {
namespace {

Relation reversed(Relation relation) {
    switch (relation) {
    case Relation::first_in_second:
        return Relation::second_in_first;
    case Relation::second_in_first:
        return Relation::first_in_second;
    default:
        return relation;
    }
}

Relation of_spheres(const Sphere &a, const Sphere &b) {
    const double distance = glm::distance(a.center, b.center);
    const double tolerance = touching
                             * std::max({largest_coordinate(a.center), largest_coordinate(b.center),
                                         a.radius, b.radius});
    if (distance > a.radius + b.radius + tolerance) {
        return Relation::apart;
    }
    if (distance + a.radius < b.radius - tolerance) {
        return Relation::first_in_second;
    }
    return distance + b.radius < a.radius - tolerance ? Relation::second_in_first
                                                      : Relation::crossing;
}

double height(const Plane &plane, const glm::dvec3 &point) {
    return glm::dot(plane.normal, point - plane.point);
}

// Two half-spaces are apart, or one in the other, only where their planes are parallel.
Relation of_half_spaces(const Plane &a, const Plane &b) {
    if (glm::length(glm::cross(a.normal, b.normal)) > touching) {
        return Relation::crossing;
    }
    const double above = height(b, a.point);  // how far a's plane is above b's
    const double tolerance =
        touching * std::max(largest_coordinate(a.point), largest_coordinate(b.point));
    if (std::abs(above) <= tolerance) {
        return Relation::crossing;
    }
    if (glm::dot(a.normal, b.normal) > 0) {
        return above < 0 ? Relation::first_in_second : Relation::second_in_first;
    }
    return above > 0 ? Relation::apart : Relation::crossing;
}

}  // namespace

BodyRelations::BodyRelations(const Scene &scene, const std::vector<Body> &bodies)
    : scene_(scene), bodies_(bodies), boxes_(bodies.size()), surfaces_(bodies.size()) {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (bodies[i].sphere >= 0) {
            const Sphere &sphere = scene.spheres[static_cast<std::size_t>(bodies[i].sphere)];
            boxes_[i] = Box{sphere.center, sphere.center}.padded(sphere.radius);
        }
        for (const std::uint32_t triangle : bodies[i].triangles) {
            if (!boxes_[i]) {
                boxes_[i].emplace();
            }
            boxes_[i]->add(box_of(corners_of(scene, scene.triangles[triangle])));
        }
    }
}

const MeshSurface &BodyRelations::surface(std::size_t body) const {
    if (!surfaces_[body]) {
        surfaces_[body] = std::make_unique<MeshSurface>(scene_, bodies_[body].triangles);
    }
    return *surfaces_[body];
}

bool BodyRelations::holds(std::size_t mesh, const glm::dvec3 &point) const {
    return std::abs(surface(mesh).winding_number(point)) > 0.5;
}

std::size_t BodyRelations::held_by(std::size_t outer, std::size_t inner) const {
    return static_cast<std::size_t>(
        std::ranges::count_if(bodies_[inner].shells, [&](std::uint32_t triangle) {
            return holds(outer, corners_of(scene_, scene_.triangles[triangle])[0]);
        }));
}

Relation BodyRelations::of_sphere_and_mesh(const Sphere &sphere, std::size_t mesh) const {
    const double tolerance = touching * std::max(largest_coordinate(sphere.center), sphere.radius);
    if (!surface(mesh).comes_within(sphere.radius + tolerance, sphere.center)) {
        return holds(mesh, sphere.center) ? Relation::first_in_second : Relation::apart;
    }
    const bool is_inside =
        std::ranges::all_of(bodies_[mesh].triangles, [&](std::uint32_t triangle) {
            return std::ranges::all_of(
                corners_of(scene_, scene_.triangles[triangle]), [&](const glm::dvec3 &corner) {
                    return glm::distance(corner, sphere.center) < sphere.radius - tolerance;
                });
        });
    return is_inside ? Relation::second_in_first : Relation::crossing;
}

Relation BodyRelations::of_meshes(std::size_t first, std::size_t second) const {
    const double tolerance = touching
                             * std::min(largest_coordinate(surface(first).box()),
                                        largest_coordinate(surface(second).box()));
    if (surface(first).comes_within(tolerance, surface(second))) {
        return Relation::crossing;
    }
    const std::size_t in_second = held_by(second, first), in_first = held_by(first, second);
    if (in_second == 0 && in_first == 0) {
        return Relation::apart;
    }
    // A body that fills a cavity of the other and more has some of the other's shells in it too.
    if (in_first == 0 && in_second == bodies_[first].shells.size()) {
        return Relation::first_in_second;
    }
    return in_second == 0 && in_first == bodies_[second].shells.size() ? Relation::second_in_first
                                                                       : Relation::crossing;
}

Relation BodyRelations::with_half_space(std::size_t body, const Plane &plane) const {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    double size = largest_coordinate(plane.point);
    const auto add = [&](const glm::dvec3 &center, double radius) {
        low = std::min(low, height(plane, center) - radius);
        high = std::max(high, height(plane, center) + radius);
        size = std::max({size, largest_coordinate(center), radius});
    };
    if (bodies_[body].sphere >= 0) {
        const Sphere &sphere = scene_.spheres[static_cast<std::size_t>(bodies_[body].sphere)];
        add(sphere.center, sphere.radius);
    }
    for (const std::uint32_t triangle : bodies_[body].triangles) {
        for (const glm::dvec3 &corner : corners_of(scene_, scene_.triangles[triangle])) {
            add(corner, 0);
        }
    }
    if (low > touching * size) {
        return Relation::apart;
    }
    return high < -touching * size ? Relation::first_in_second : Relation::crossing;
}

// Spheres first, then planes, then meshes.
Relation BodyRelations::in_order(std::size_t first, std::size_t second) const {
    const Body &a = bodies_[first], &b = bodies_[second];
    const auto sphere = [&](const Body &body) -> const Sphere & {
        return scene_.spheres[static_cast<std::size_t>(body.sphere)];
    };
    const auto plane = [&](const Body &body) -> const Plane & {
        return scene_.planes[static_cast<std::size_t>(body.plane)];
    };
    if (b.sphere >= 0) {
        return of_spheres(sphere(a), sphere(b));
    }
    if (b.plane >= 0) {
        return a.plane >= 0 ? of_half_spaces(plane(a), plane(b)) : with_half_space(first, plane(b));
    }
    if (a.sphere >= 0) {
        return of_sphere_and_mesh(sphere(a), second);
    }
    return a.plane >= 0 ? reversed(with_half_space(second, plane(a))) : of_meshes(first, second);
}

Relation BodyRelations::of(std::size_t first, std::size_t second) const {
    const auto kind = [&](std::size_t body) {
        return bodies_[body].sphere >= 0 ? 0 : bodies_[body].plane >= 0 ? 1 : 2;
    };
    return kind(first) <= kind(second) ? in_order(first, second)
                                       : reversed(in_order(second, first));
}

}  // namespace stagelight
