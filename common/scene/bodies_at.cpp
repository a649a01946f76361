// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "scene/bodies.h"
#include "scene/box_tree.h"
#include "scene/errors.h"
#include "scene/mesh_surface.h"
#include "scene/rounding.h"

namespace stagelight {
namespace {

struct Held {
    bool is_inside = false;
    bool is_on_surface = false;
    double winding = 0;  // of a body with holes
};

Held by_distance(double above, double tolerance) {
    return {.is_inside = above < -tolerance, .is_on_surface = std::abs(above) <= tolerance};
}

Held held(const Scene &scene, const Body &body, const glm::dvec3 &point) {
    const double size = largest_coordinate(point);
    if (body.sphere >= 0) {
        const Sphere &sphere = scene.spheres[static_cast<std::size_t>(body.sphere)];
        const double tolerance =
            4 * float_rounding * std::max({size, largest_coordinate(sphere.center), sphere.radius});
        return by_distance(glm::distance(point, sphere.center) - sphere.radius, tolerance);
    }
    if (body.plane >= 0) {
        const Plane &plane = scene.planes[static_cast<std::size_t>(body.plane)];
        const double above = glm::dot(plane.normal, point - plane.point);
        return by_distance(above,
                           4 * float_rounding * glm::dot(glm::abs(plane.normal), glm::abs(point)));
    }
    Box box;
    for (const std::uint32_t triangle : body.triangles) {
        box.add(box_of(corners_of(scene, scene.triangles[triangle])));
    }
    const double tolerance = 4 * float_rounding * std::max(size, largest_coordinate(box));
    if (!box.padded(tolerance).overlaps({point, point})) {
        return {};
    }
    const MeshSurface surface(scene, body.triangles);
    if (surface.comes_within(tolerance, point)) {
        return {.is_on_surface = true};
    }
    const double winding = surface.winding_number(point);
    return {.is_inside = std::abs(winding) > 0.5, .winding = body.is_closed ? 0 : winding};
}

}  // namespace

std::vector<int> bodies_at(const Scene &scene, const Bodies &bodies, const glm::dvec3 &point,
                           std::vector<std::string> *warnings) {
    std::vector<int> holding;
    for (std::size_t i = 0; i < bodies.list.size(); ++i) {
        const Body &body = bodies.list[i];
        const Held found = held(scene, body, point);
        if (found.is_inside) {
            holding.push_back(static_cast<int>(i));
        }
        if (warnings && found.is_on_surface) {
            warnings->push_back(fmt::format("{}: the eye lies on the surface of this dielectric; "
                                            "it is taken to be outside",
                                            to_string(body.where)));
        }
        if (warnings && std::abs(found.winding) > 0.1) {
            warnings->push_back(fmt::format(
                "{}: this dielectric has holes, so whether the eye is inside can't be told; it is "
                "taken to be {}, since {:.0f} % of what it sees around it is this mesh",
                to_string(body.where), found.is_inside ? "inside" : "outside",
                100 * std::abs(found.winding)));
        }
    }
    return holding;
}

}  // namespace stagelight
