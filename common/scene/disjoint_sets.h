// SPDX-License-Identifier: MIT
// Disjoint sets (Tarjan, Efficiency of a Good But Not Linear Set Union Algorithm, 1975), as a tree
// each: `root` has each member's parent, and a root is its own.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace stagelight {

inline std::uint32_t root_of(std::vector<std::uint32_t> &root, std::uint32_t member) {
    while (root[member] != member) {
        member = root[member] = root[root[member]];
    }
    return member;
}

// The lesser one becomes the root.
inline void join(std::vector<std::uint32_t> &root, std::uint32_t a, std::uint32_t b) {
    const auto [low, high] = std::minmax({root_of(root, a), root_of(root, b)});
    root[high] = low;
}

}  // namespace stagelight
