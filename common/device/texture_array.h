// SPDX-License-Identifier: MIT
// All textures of a scene as one array of images, which is how OpenCL 1.2 takes many.
#pragma once

#include <cstddef>

#include "device/opencl.h"
#include "device/texture_pages.h"
#include "image/transfer.h"
#include "scene/scene.h"

namespace stagelight {

// Where the scene's textures lie in an array that the device takes, if it takes one.
TexturePages pages_of(const Scene &scene, const cl::Device &device);

// What that array takes.
std::size_t texture_bytes(const Scene &scene, const cl::Device &device, Transfer decode);

// Several textures on a layer, RGBA: kernels/texture.cl wants a border of one texel around each,
// which continues it as its wrap says.
//
// Texels that are not decoded keep the file's 8 bits. Light needs a finer grain in the dark: of
// sRGB's darkest 18 codes 8 linear bits would leave 2. It is kept in half precision, whose steps
// grow with the light: all 256 codes of both curves come back, none off by more than 0.04 of a
// code. 16 linear bits are as good for sRGB (0.02), but lose code 1 of the paper's power, which is
// 5e-6. Float would take twice the room. Measured with PoCL 3.1 and rusticl 22.3.6, which read all
// three right in every layer, filter them within 2e-7, and draw as fast as with 8 bits.
class TextureArray {
public:
    // Texels go through `decode` before any filter. Throws UserError when a texture, or all
    // together, are more than the device takes, and MachineError when it takes no images.
    TextureArray(const cl::Context &context, const cl::Device &device, const Scene &scene,
                 Transfer decode);

    const cl::Image2DArray &image() const { return image_; }
    std::size_t bytes() const { return bytes_; }

private:
    cl::Image2DArray image_;
    std::size_t bytes_ = 0;
};

}  // namespace stagelight
