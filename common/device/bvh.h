// SPDX-License-Identifier: MIT
// A bounding volume hierarchy over a scene's triangles, as kernels/bvh.cl walks it.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/scene.h"
#include "scene_types.h"

namespace stagelight {

struct Bvh {
    std::vector<device::BvhNode> nodes;  // the first is the root; parents before children
    std::vector<std::uint32_t> order;    // triangle of the scene at each place of a leaf
    int depth = 0;                       // nodes on the longest way down
};

// Built on all cores: binned by the surface area heuristic (Wald, On Fast Construction of SAH-based
// Bounding Volume Hierarchies, 2007). The boxes hold the vertices as the device has them, in float.
// The tree is the same on any number of cores; a scene without triangles has no nodes.
Bvh build_bvh(const Scene &scene);

}  // namespace stagelight
