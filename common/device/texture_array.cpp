// SPDX-License-Identifier: MIT
#include "device/texture_array.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <vector>

#include <fmt/format.h>

#include "scene/errors.h"

namespace stagelight {
namespace {

constexpr std::size_t texel_bytes = 4;

std::size_t wrap(std::size_t index_with_border, int size) {
    const auto count = static_cast<std::size_t>(size);
    return (index_with_border + count - 1) % count;
}

// The texture with its border, in the upper left corner of a layer of `width` texels a row.
void copy_with_border(const Texture &texture, std::uint8_t *layer, std::size_t width) {
    const auto columns = static_cast<std::size_t>(texture.width) + 2;
    const auto rows = static_cast<std::size_t>(texture.height) + 2;
    for (std::size_t y = 0; y < rows; ++y) {
        for (std::size_t x = 0; x < columns; ++x) {
            const std::size_t source =
                wrap(y, texture.height) * static_cast<std::size_t>(texture.width)
                + wrap(x, texture.width);
            std::memcpy(layer + (y * width + x) * texel_bytes,
                        texture.texels.data() + source * texel_bytes, texel_bytes);
        }
    }
}

void require_size(const Texture &texture, std::size_t largest_width, std::size_t largest_height) {
    if (static_cast<std::size_t>(texture.width) + 2 > largest_width
        || static_cast<std::size_t>(texture.height) + 2 > largest_height) {
        throw UserError(fmt::format("{}: {} is {}x{} pixels; this device takes at most {}x{}",
                                    to_string(texture.where), texture.file.string(), texture.width,
                                    texture.height, largest_width - 2, largest_height - 2));
    }
}

}  // namespace

TextureArray::TextureArray(const cl::Context &context, const cl::Device &device,
                           const Scene &scene) {
    if (device.getInfo<CL_DEVICE_IMAGE_SUPPORT>() == CL_FALSE) {
        throw MachineError(device.getInfo<CL_DEVICE_NAME>()
                           + " has no images, which textures need; choose another --device");
    }
    std::size_t width = 0;
    std::size_t height = 0;
    for (const Texture &texture : scene.textures) {
        require_size(texture, device.getInfo<CL_DEVICE_IMAGE2D_MAX_WIDTH>(),
                     device.getInfo<CL_DEVICE_IMAGE2D_MAX_HEIGHT>());
        width = std::max(width, static_cast<std::size_t>(texture.width) + 2);
        height = std::max(height, static_cast<std::size_t>(texture.height) + 2);
    }
    const std::size_t layers = scene.textures.size();
    bytes_ = layers * width * height * texel_bytes;
    if (layers > device.getInfo<CL_DEVICE_IMAGE_MAX_ARRAY_SIZE>()
        || bytes_ > device.getInfo<CL_DEVICE_MAX_MEM_ALLOC_SIZE>()) {
        throw UserError(fmt::format(
            "{}: {} textures of up to {}x{} texels take {} bytes; this device takes at most {} "
            "textures and {} bytes",
            scene.file.string(), layers, width, height, bytes_,
            device.getInfo<CL_DEVICE_IMAGE_MAX_ARRAY_SIZE>(),
            device.getInfo<CL_DEVICE_MAX_MEM_ALLOC_SIZE>()));
    }
    std::vector<std::uint8_t> texels(bytes_);
    for (std::size_t i = 0; i < layers; ++i) {
        copy_with_border(scene.textures[i], texels.data() + i * width * height * texel_bytes,
                         width);
    }
    image_ = cl::Image2DArray(context, CL_MEM_READ_ONLY | CL_MEM_COPY_HOST_PTR,
                              cl::ImageFormat(CL_RGBA, CL_UNORM_INT8), layers, width, height, 0, 0,
                              texels.data());
}

}  // namespace stagelight
