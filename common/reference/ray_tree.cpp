// SPDX-License-Identifier: MIT
#include "reference/ray_tree.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <glm/geometric.hpp>

namespace stagelight::reference {

namespace {

// cos 18°: a normal that turns further from one pixel to the next is a crease. Smooth patches
// turn that fast only in the last pixel before a silhouette, which is an edge anyhow.
constexpr double crease_cosine = 0.95;

// sin 17°, see below.
constexpr double jump_sine = 0.3;

bool crease(const RayTree &one, const RayTree &other) {
    return glm::dot(one.shading_normal, other.shading_normal) < crease_cosine;
}

// One part of a patch in front of another. On an arc the chord between two points is
// perpendicular to the sum of their normals, however steeply it is seen; from one part to
// another it runs along the ray.
bool jump(const RayTree &one, const RayTree &other) {
    const glm::dvec3 chord = other.point - one.point;
    const glm::dvec3 normals = one.geometric_normal + other.geometric_normal;
    return std::abs(glm::dot(chord, normals))
           > jump_sine * glm::length(chord) * glm::length(normals);
}

bool shadow_edge(Shadow one, Shadow other) {
    return one != other && one != Shadow::unlit && other != Shadow::unlit;
}

bool any_pair(const auto &one, const auto &other, auto differs) {
    return !std::equal(one.begin(), one.end(), other.begin(), other.end(),
                       [&](const auto &a, const auto &b) { return !differs(a, b); });
}

}  // namespace

bool differ(const RayTree &one, const RayTree &other) {
    if (std::min(one.weight, other.weight) < least_weight)
        return false;
    if (one.surface != other.surface || one.from_behind != other.from_behind)
        return true;
    // Spheres and planes are convex: what is seen of them has neither creases nor jumps.
    if (one.surface.kind == Surface::Kind::patch && (crease(one, other) || jump(one, other)))
        return true;
    return any_pair(one.shadows, other.shadows, shadow_edge)
           || any_pair(one.children, other.children, differ);
}

std::vector<std::uint8_t> edge_mask(int width, int height, const std::vector<std::uint8_t> &seams) {
    std::vector<std::uint8_t> mask(seams.size());
    const auto mark = [&](int left, int top, int right, int bottom) {
        for (int y = std::max(top, 0); y <= std::min(bottom, height - 1); ++y)
            for (int x = std::max(left, 0); x <= std::min(right, width - 1); ++x)
                mask[std::size_t(y) * std::size_t(width) + std::size_t(x)] = 1;
    };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const auto seam = seams[std::size_t(y) * std::size_t(width) + std::size_t(x)];
            if (seam & seam_right)
                mark(x - 1, y - 1, x + 2, y + 1);
            if (seam & seam_below)
                mark(x - 1, y - 1, x + 1, y + 2);
        }
    return mask;
}

}  // namespace stagelight::reference
