// SPDX-License-Identifier: MIT
// Whether a scene and its picture fit a device, asked before anything is built or allocated.
#pragma once

#include <cstddef>

#include "device/opencl.h"
#include "image/transfer.h"
#include "scene/scene.h"

namespace stagelight {

// What a picture takes as a buffer. Throws UserError where that is more than the device takes.
std::size_t picture_bytes(const cl::Device &device, int width, int height);

// Throws UserError, with the bytes needed and had, where triangles, textures (decoded or not) and
// picture together are more than the device's memory. `pictures` is how many buffers of its size
// there are. The nodes of a tree, whose number is known when it is built, come on top.
void require_memory(const cl::Device &device, const Scene &scene, Transfer decode,
                    std::size_t picture, int pictures);

}  // namespace stagelight
