// SPDX-License-Identifier: MIT
#include "scene/mesh_surface.h"

#include <cmath>
#include <cstddef>
#include <numbers>

#include <glm/geometric.hpp>

namespace stagelight {
namespace {

std::vector<TriangleCorners> all_corners(const Scene &scene,
                                         std::span<const std::uint32_t> triangles) {
    std::vector<TriangleCorners> corners;
    corners.reserve(triangles.size());
    for (const std::uint32_t triangle : triangles) {
        corners.push_back(corners_of(scene, scene.triangles[triangle]));
    }
    return corners;
}

std::vector<Box> boxes_of(const std::vector<TriangleCorners> &triangles) {
    std::vector<Box> boxes;
    boxes.reserve(triangles.size());
    for (const TriangleCorners &triangle : triangles) {
        boxes.push_back(box_of(triangle));
    }
    return boxes;
}

glm::dvec3 area_of(const TriangleCorners &triangle) {
    return 0.5 * glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
}

// van Oosterom and Strackee, The Solid Angle of a Plane Triangle, 1983, equation 8.
double solid_angle(const TriangleCorners &triangle, const glm::dvec3 &point) {
    const glm::dvec3 a = triangle[0] - point, b = triangle[1] - point, c = triangle[2] - point;
    const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
    const double numerator = glm::dot(a, glm::cross(b, c));
    const double denominator =
        la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb;
    return 2 * std::atan2(numerator, denominator);
}

}  // namespace

TriangleCorners corners_of(const Scene &scene, const Triangle &triangle) {
    return {scene.vertices[triangle.vertices[0]].position,
            scene.vertices[triangle.vertices[1]].position,
            scene.vertices[triangle.vertices[2]].position};
}

Box box_of(const TriangleCorners &triangle) {
    Box box;
    for (const glm::dvec3 &corner : triangle) {
        box.add(corner);
    }
    return box;
}

MeshSurface::MeshSurface(const Scene &scene, std::span<const std::uint32_t> triangles)
    : triangles_(all_corners(scene, triangles)), tree_(boxes_of(triangles_)) {
    for (const BoxTree::Node &node : tree_.nodes()) {
        Dipole dipole{glm::dvec3(0), glm::dvec3(0), 0};
        double size = 0;
        for (std::uint32_t i = node.first; i < node.last; ++i) {
            const TriangleCorners &triangle = triangles_[tree_.order()[i]];
            const glm::dvec3 area = area_of(triangle);
            dipole.area += area;
            dipole.center += glm::length(area) / 3 * (triangle[0] + triangle[1] + triangle[2]);
            size += glm::length(area);
        }
        dipole.center = size > 0 ? dipole.center / size : node.box.center();
        dipole.radius =
            glm::length(glm::max(dipole.center - node.box.low, node.box.high - dipole.center));
        dipoles_.push_back(dipole);
    }
}

// From far off a node is one small facet: the first term of Barill et al., Fast Winding Numbers for
// Soups and Clouds, 2018, section 3.
double MeshSurface::winding_number(const glm::dvec3 &point) const {
    constexpr double far = 3;  // in radii: the whole is off by less than a hundredth
    double angle = 0;
    std::vector<std::uint32_t> open{0};
    while (!open.empty()) {
        const std::uint32_t index = open.back();
        open.pop_back();
        const BoxTree::Node &node = tree_.nodes()[index];
        const Dipole &dipole = dipoles_[index];
        const glm::dvec3 to = dipole.center - point;
        const double distance = glm::length(to);
        if (distance > far * dipole.radius) {
            angle += glm::dot(dipole.area, to) / (distance * distance * distance);
        } else if (node.second_child != 0) {
            open.push_back(index + 1);
            open.push_back(node.second_child);
        } else {
            for (std::uint32_t i = node.first; i < node.last; ++i) {
                angle += solid_angle(triangles_[tree_.order()[i]], point);
            }
        }
    }
    return angle / (4 * std::numbers::pi);
}

bool MeshSurface::comes_within(double distance, const glm::dvec3 &point) const {
    return tree_.any(Box{point, point}.padded(distance), [&](std::uint32_t i) {
        return glm::distance(closest_point(triangles_[i], point), point) <= distance;
    });
}

bool MeshSurface::comes_within(double distance, const MeshSurface &other) const {
    if (triangles_.size() > other.triangles_.size()) {  // fewer walks down a tree
        return other.comes_within(distance, *this);
    }
    for (const TriangleCorners &triangle : triangles_) {
        const Box near = box_of(triangle).padded(distance);
        if (near.overlaps(other.box()) && other.tree_.any(near, [&](std::uint32_t i) {
                return stagelight::distance(triangle, other.triangles_[i]) <= distance;
            })) {
            return true;
        }
    }
    return false;
}

}  // namespace stagelight
