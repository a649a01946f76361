// SPDX-License-Identifier: MIT
// All textures of a scene as one array of images, which is how OpenCL 1.2 takes many.
#pragma once

#include <cstddef>

#include "device/opencl.h"
#include "scene/scene.h"

namespace stagelight {

// One layer a texture, RGBA of 8 bits, as wide and high as the largest of them and two texels
// more: kernels/texture.cl wants a border of one texel, copied from the opposite edge.
class TextureArray {
public:
    // Throws UserError when a texture, or all together, are more than the device takes, and
    // MachineError when it takes no images.
    TextureArray(const cl::Context &context, const cl::Device &device, const Scene &scene);

    const cl::Image2DArray &image() const { return image_; }
    std::size_t bytes() const { return bytes_; }

private:
    cl::Image2DArray image_;
    std::size_t bytes_ = 0;
};

}  // namespace stagelight
