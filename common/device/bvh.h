// SPDX-License-Identifier: MIT
// A bounding volume hierarchy over a scene's triangles, as kernels/bvh.cl walks it.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/scene.h"

namespace stagelight {

struct Bvh {
    // BvhNode after BvhNode (kernels/scene_types.h), a float as its bits; the first is the root,
    // and nodes come before their children.
    std::vector<std::uint32_t> nodes;
    int width = 0;                     // children that a node has room for
    int stack_size = 0;                // nodes that can be waiting at a time
    std::vector<std::uint32_t> order;  // triangle of the scene at each place of a leaf
};

// Built on all cores: binned by the surface area heuristic (Wald, On Fast Construction of SAH-based
// Bounding Volume Hierarchies, 2007), then drawn together to `width` children a node (Wald et al.,
// Getting Rid of Packets, 2008, section 3). The boxes hold the vertices as the device has them, in
// float, with room for what rounding does to rays. The tree is the same on any number of cores; a
// scene without triangles has no nodes.
Bvh build_bvh(const Scene &scene, int width = 4);

}  // namespace stagelight
