// SPDX-License-Identifier: MIT
// A tree of boxes, to find those that overlap.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <glm/vector_relational.hpp>

namespace stagelight {

// Empty until a point is added.
struct Box {
    glm::dvec3 low{std::numeric_limits<double>::infinity()};
    glm::dvec3 high{-std::numeric_limits<double>::infinity()};

    void add(const glm::dvec3 &point) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    void add(const Box &box) {
        low = glm::min(low, box.low);
        high = glm::max(high, box.high);
    }
    glm::dvec3 center() const { return 0.5 * (low + high); }
    Box padded(double by) const { return {low - by, high + by}; }
    // Touching counts.
    bool overlaps(const Box &other) const {
        return glm::all(glm::lessThanEqual(low, other.high))
               && glm::all(glm::lessThanEqual(other.low, high));
    }
    bool contains(const Box &other) const {
        return glm::all(glm::lessThanEqual(low, other.low))
               && glm::all(glm::lessThanEqual(other.high, high));
    }
};

// The largest of the three components' magnitudes.
double largest_coordinate(const glm::dvec3 &point);
double largest_coordinate(const Box &box);

class BoxTree {
public:
    // The first child of a node follows it. A leaf has no second child, which would be 0.
    struct Node {
        Box box;
        std::uint32_t first, last;  // its part of order()
        std::uint32_t second_child = 0;
    };

    explicit BoxTree(std::span<const Box> boxes);

    const std::vector<Node> &nodes() const { return nodes_; }  // children after their parents
    const std::vector<std::uint32_t> &order() const { return order_; }

    // Calls `visit` with the index of each box that overlaps `query`, until it returns true.
    // Whether it did.
    template <typename Visit> bool any(const Box &query, const Visit &visit) const {
        if (nodes_.empty()) {
            return false;
        }
        std::array<std::uint32_t, 64> open{};  // halving leaves at most 33 levels
        std::size_t count = 1;
        while (count > 0) {
            const std::uint32_t index = open[--count];
            const Node &node = nodes_[index];
            if (!node.box.overlaps(query)) {
                continue;
            }
            if (node.second_child != 0) {
                open[count++] = node.second_child;
                open[count++] = index + 1;
                continue;
            }
            for (std::uint32_t i = node.first; i < node.last; ++i) {
                if (boxes_[order_[i]].overlaps(query) && visit(order_[i])) {
                    return true;
                }
            }
        }
        return false;
    }

    template <typename Visit> void each(const Box &query, const Visit &visit) const {
        any(query, [&](std::uint32_t index) {
            visit(index);
            return false;
        });
    }

private:
    std::vector<Box> boxes_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
};

}  // namespace stagelight
