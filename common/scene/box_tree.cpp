// SPDX-License-Identifier: MIT
#include "scene/box_tree.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace stagelight {

double largest_coordinate(const glm::dvec3 &point) {
    const glm::dvec3 size = glm::abs(point);
    return std::max({size.x, size.y, size.z});
}

double largest_coordinate(const Box &box) {
    return std::max(largest_coordinate(box.low), largest_coordinate(box.high));
}

// Halved at the median of the longest axis, so that it is never deep.
BoxTree::BoxTree(std::span<const Box> boxes) : boxes_(boxes.begin(), boxes.end()) {
    constexpr std::uint32_t leaf_size = 4;
    order_.resize(boxes.size());
    std::iota(order_.begin(), order_.end(), 0u);
    constexpr std::uint32_t no_parent = ~0u;
    struct Waiting {
        std::uint32_t first, last, parent_of_second;
    };
    std::vector<Waiting> waiting;
    if (!boxes.empty()) {
        waiting.push_back({0, static_cast<std::uint32_t>(boxes.size()), no_parent});
    }
    while (!waiting.empty()) {
        const Waiting range = waiting.back();
        waiting.pop_back();
        const auto index = static_cast<std::uint32_t>(nodes_.size());
        if (range.parent_of_second != no_parent) {
            nodes_[range.parent_of_second].second_child = index;
        }
        Node node{.box = {}, .first = range.first, .last = range.last};
        Box centers;
        for (std::uint32_t i = range.first; i < range.last; ++i) {
            node.box.add(boxes_[order_[i]]);
            centers.add(boxes_[order_[i]].center());
        }
        nodes_.push_back(node);
        if (range.last - range.first > leaf_size) {
            const glm::dvec3 size = centers.high - centers.low;
            const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
            const std::uint32_t middle = range.first + (range.last - range.first) / 2;
            std::nth_element(order_.begin() + range.first, order_.begin() + middle,
                             order_.begin() + range.last, [&](std::uint32_t a, std::uint32_t b) {
                                 return boxes_[a].center()[axis] < boxes_[b].center()[axis];
                             });
            waiting.push_back({middle, range.last, index});
            waiting.push_back({range.first, middle, no_parent});
        }
    }
}

}  // namespace stagelight
