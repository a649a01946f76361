// SPDX-License-Identifier: MIT
// A bounding volume hierarchy over a scene's triangles, as kernels/bvh.cl walks it.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/scene.h"

namespace stagelight {

// How boxes and triangles lie on the device.
struct BvhLayout {
    int width = 4;         // children that a node has room for
    bool has_room = true;  // boxes are grown by what rounding does to rays
};

struct Bvh {
    // BvhNode after BvhNode (kernels/scene.cl), floats as their bits; the first is the root, and
    // nodes come before their children.
    std::vector<std::uint32_t> nodes;
    BvhLayout layout;
    int stack_size = 0;                // nodes that can be waiting at a time
    std::vector<std::uint32_t> order;  // triangle of the scene at each place of a leaf
};

// Built on all cores: binned by the surface area heuristic (Wald, On Fast Construction of SAH-based
// Bounding Volume Hierarchies, 2007), then drawn together to `width` children a node (Wald et al.,
// Getting Rid of Packets, 2008, section 3). The boxes hold the vertices as the device has them,
// rounded as `layout` says. The tree is the same on any number of cores; a scene without triangles
// has no nodes.
Bvh build_bvh(const Scene &scene, const BvhLayout &layout = {});

}  // namespace stagelight
