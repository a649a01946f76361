// SPDX-License-Identifier: MIT
// Triangles of a scene, arranged so that questions about what they enclose are quick to answer.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scene/box_tree.h"
#include "scene/distance.h"
#include "scene/scene.h"

namespace stagelight {

TriangleCorners corners_of(const Scene &scene, const Triangle &triangle);

Box box_of(const TriangleCorners &triangle);

class MeshSurface {
public:
    MeshSurface(const Scene &scene, std::span<const std::uint32_t> triangles);

    const Box &box() const { return tree_.nodes().front().box; }

    // How often the surface goes round the point: the solid angles of its triangles, seen from
    // there, over 4 pi. 1 inside of a closed surface that faces outwards, 0 outside; where there
    // are holes, something between (Jacobson, Kavan and Sorkine-Hornung, Robust Inside-Outside
    // Segmentation using Generalized Winding Numbers, 2013).
    double winding_number(const glm::dvec3 &point) const;

    bool comes_within(double distance, const glm::dvec3 &point) const;
    bool comes_within(double distance, const MeshSurface &other) const;

private:
    // What a node's triangles look like from far away.
    struct Dipole {
        glm::dvec3 center;
        glm::dvec3 area;  // the sum of the triangles' normals, as long as their areas
        double radius;    // no corner is farther from the centre
    };

    std::vector<TriangleCorners> triangles_;
    BoxTree tree_;
    std::vector<Dipole> dipoles_;  // of each node
};

}  // namespace stagelight
