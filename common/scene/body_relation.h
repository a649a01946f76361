// SPDX-License-Identifier: MIT
// How two bodies lie to each other.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "scene/bodies.h"
#include "scene/box_tree.h"
#include "scene/mesh_surface.h"

namespace stagelight {

enum class Relation { apart, crossing, first_in_second, second_in_first };

class BodyRelations {
public:
    BodyRelations(const Scene &scene, const std::vector<Body> &bodies);

    // None for a half-space, which has none.
    const std::optional<Box> &box(std::size_t body) const { return boxes_[body]; }

    // Bodies that touch are crossing.
    Relation of(std::size_t first, std::size_t second) const;

private:
    const MeshSurface &surface(std::size_t body) const;
    bool holds(std::size_t mesh, const glm::dvec3 &point) const;
    // How many shells of the mesh `inner` lie in the mesh `outer`. Their surfaces don't meet.
    std::size_t held_by(std::size_t outer, std::size_t inner) const;
    Relation of_sphere_and_mesh(const Sphere &sphere, std::size_t mesh) const;
    Relation of_meshes(std::size_t first, std::size_t second) const;
    Relation with_half_space(std::size_t body, const Plane &plane) const;
    Relation in_order(std::size_t first, std::size_t second) const;

    const Scene &scene_;
    const std::vector<Body> &bodies_;
    std::vector<std::optional<Box>> boxes_;
    mutable std::vector<std::unique_ptr<const MeshSurface>> surfaces_;  // once asked for
};

}  // namespace stagelight
