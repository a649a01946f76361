// SPDX-License-Identifier: MIT
// Spheres around triangles around spheres: spares the reference most of its triangle tests,
// and decides none of them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "reference/intersect.h"
#include "scene/scene.h"

namespace stagelight::reference {

template <typename Number>
Corners<Number> corners_of(const Scene &scene, const Triangle &triangle) {
    const auto corner = [&](std::size_t i) {
        return Vec<Number>(scene.vertices[triangle.vertices[i]].position);
    };
    return {corner(0), corner(1), corner(2)};
}

template <typename Number> class TriangleTree {
public:
    // Triangles without an area can't be hit and are left out.
    explicit TriangleTree(const Scene &scene) : scene_(scene) {
        for (std::size_t i = 0; i < scene.triangles.size(); ++i)
            if (facing(corners(i)) != Vec<Number>(0))
                order_.push_back(i);
        if (!order_.empty())
            build(0, order_.size());
    }

    Corners<Number> corners(std::size_t triangle) const {
        return corners_of<Number>(scene_, scene_.triangles[triangle]);
    }

    // Calls visit(triangle) for each triangle that the ray may meet nearer than `limit`, which
    // visit may lower, until it returns true. True when it did.
    template <typename Visit>
    bool search(const Ray<Number> &ray, const Number &limit, Visit visit) const {
        return !nodes_.empty() && search(0, ray, limit, visit);
    }

private:
    static constexpr std::size_t leaf_size = 4;

    struct Node {
        Vec<Number> center;
        Number radius;
        std::size_t first, last;   // of order_
        std::size_t second_child;  // the first one follows its parent
    };

    std::size_t build(std::size_t first, std::size_t last) {
        const std::size_t self = nodes_.size();
        Vec<Number> low(std::numeric_limits<Number>::infinity()), high = -low;
        each_corner(first, last, [&](const Vec<Number> &corner) {
            low = glm::min(low, corner);
            high = glm::max(high, corner);
        });
        nodes_.push_back({(low + high) / Number(2), 0, first, last, 0});
        each_corner(first, last, [&](const Vec<Number> &corner) {
            nodes_[self].radius =
                std::max(nodes_[self].radius, glm::distance(corner, nodes_[self].center));
        });
        nodes_[self].radius *= Number(1.01);  // no rounding loses a triangle
        if (last - first > leaf_size) {
            const std::size_t middle = split(first, last, high - low);
            build(first, middle);
            nodes_[self].second_child = build(middle, last);
        }
        return self;
    }

    template <typename Use> void each_corner(std::size_t first, std::size_t last, Use use) const {
        for (std::size_t i = first; i < last; ++i) {
            const Corners<Number> triangle = corners(order_[i]);
            use(triangle.a);
            use(triangle.b);
            use(triangle.c);
        }
    }

    // Halves at the median along the longest extent.
    std::size_t split(std::size_t first, std::size_t last, const Vec<Number> &extent) {
        const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0
                         : extent.y >= extent.z                       ? 1
                                                                      : 2;
        const std::size_t middle = first + (last - first) / 2;
        const auto at = [&](std::size_t i) { return order_.begin() + std::ptrdiff_t(i); };
        std::nth_element(at(first), at(middle), at(last), [&](std::size_t i, std::size_t j) {
            return along(i, axis) < along(j, axis);
        });
        return middle;
    }

    Number along(std::size_t triangle, int axis) const {
        const Corners<Number> it = corners(triangle);
        return (it.a + it.b + it.c)[axis];
    }

    template <typename Visit>
    bool search(std::size_t index, const Ray<Number> &ray, const Number &limit,
                Visit &visit) const {
        const Node &node = nodes_[index];
        const Vec<Number> to_center = node.center - ray.origin;
        const Number ahead = glm::dot(to_center, ray.direction);
        if (ahead + node.radius < 0 || ahead - node.radius > limit
            || glm::length(to_center - ahead * ray.direction) > node.radius)
            return false;
        if (node.last - node.first > leaf_size)
            return search(index + 1, ray, limit, visit)
                   || search(node.second_child, ray, limit, visit);
        return std::any_of(order_.begin() + std::ptrdiff_t(node.first),
                           order_.begin() + std::ptrdiff_t(node.last), visit);
    }

    const Scene &scene_;
    std::vector<std::size_t> order_;
    std::vector<Node> nodes_;
};

}  // namespace stagelight::reference
