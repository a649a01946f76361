// SPDX-License-Identifier: MIT
// What stage 01 shows, which has no light yet.
#pragma once

#include "reference/world.h"

namespace stagelight::reference {

// (½ + ½ N) with a contour line for each unit of distance (docs/shading.md, "Stage 01").
template <typename Number>
Vec<Number> normals_and_distances(const World<Number> &world, const Ray<Number> &ray,
                                  RayTree &tree) {
    tree.weight = 1;
    const auto hit = world.closest_hit(ray);
    if (!hit)
        return Vec<Number>(world.scene().background);
    record(tree, *hit);
    const Number half = Number(0.5), t = hit->distance;
    const Number line = half - half * std::cos(2 * std::numbers::pi_v<Number> * t);
    return (half + half * hit->shading_normal) * (1 - line / 5 / (1 + t * t / 50));
}

}  // namespace stagelight::reference
