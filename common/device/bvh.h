// SPDX-License-Identifier: MIT
// A bounding volume hierarchy over a scene's spheres and triangles, as kernels/tree.cl walks it.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/scene.h"
#include "scene_types.h"

namespace stagelight {

struct Bvh {
    // The first is the root, and nodes come before their children.
    std::vector<device::BvhNode> nodes;
    int stack_size = 0;  // nodes that can be waiting at a time
    // Of the scene, at each place of the leaves: a leaf has shapes of one kind.
    std::vector<std::uint32_t> triangles;
    std::vector<std::uint32_t> spheres;
};

// Built on all cores: binned by the surface area heuristic (Wald, On Fast Construction of SAH-based
// Bounding Volume Hierarchies, 2007), then drawn together to four children a node (Wald et al.,
// Getting Rid of Packets, 2008, section 3). The boxes hold the shapes as the device has them,
// padded by what rounding does to rays unless it says otherwise. The tree is the same on any number
// of cores; a scene with neither spheres nor triangles has no nodes.
Bvh build_bvh(const Scene &scene, bool padded = true);

}  // namespace stagelight
