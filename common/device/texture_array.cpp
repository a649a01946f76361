// SPDX-License-Identifier: MIT
#include "device/texture_array.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <vector>

#include <CL/cl_half.h>
#include <fmt/format.h>

#include "scene/errors.h"

namespace stagelight {
namespace {

constexpr std::size_t channels = 4;

// What is stored for each of a channel's 256 codes.
template <typename Channel> using Codes = std::array<Channel, 256>;

Codes<std::uint8_t> undecoded_codes() {
    Codes<std::uint8_t> codes{};
    std::iota(codes.begin(), codes.end(), std::uint8_t{0});
    return codes;
}

// #region decoded_codes
Codes<cl_half> decoded_codes(Transfer decode) {
    Codes<cl_half> codes{};
    for (std::size_t code = 0; code < codes.size(); ++code) {
        const float light = stagelight::decode(decode, static_cast<float>(code) / 255);
        codes[code] = cl_half_from_float(light, CL_HALF_RTE);
    }
    return codes;
}
// #endregion decoded_codes

std::size_t wrap(std::size_t index_with_border, int size) {
    const auto count = static_cast<std::size_t>(size);
    return (index_with_border + count - 1) % count;
}

// #region copy_with_border
// The texture with its border, in the upper left corner of a layer of `width` texels a row. Alpha
// goes the way of the others: nobody reads it.
template <typename Channel>
void copy_with_border(const Texture &texture, const Codes<Channel> &codes, Channel *layer,
                      std::size_t width) {
    const auto columns = static_cast<std::size_t>(texture.width) + 2;
    const auto rows = static_cast<std::size_t>(texture.height) + 2;
    for (std::size_t y = 0; y < rows; ++y) {
        for (std::size_t x = 0; x < columns; ++x) {
            const std::size_t source =
                wrap(y, texture.height) * static_cast<std::size_t>(texture.width)
                + wrap(x, texture.width);
            std::transform(&texture.texels[source * channels],
                           &texture.texels[source * channels] + channels,
                           layer + (y * width + x) * channels,
                           [&codes](std::uint8_t code) { return codes[code]; });
        }
    }
}
// #endregion copy_with_border

template <typename Channel>
cl::Image2DArray make_image(const cl::Context &context, const std::vector<Texture> &textures,
                            std::size_t width, std::size_t height, cl_channel_type type,
                            const Codes<Channel> &codes) {
    const std::size_t layer = width * height * channels;
    std::vector<Channel> texels(textures.size() * layer);
    for (std::size_t i = 0; i < textures.size(); ++i) {
        copy_with_border(textures[i], codes, texels.data() + i * layer, width);
    }
    return {context,
            CL_MEM_READ_ONLY | CL_MEM_COPY_HOST_PTR,
            cl::ImageFormat(CL_RGBA, type),
            textures.size(),
            width,
            height,
            0,
            0,
            texels.data()};
}

// Width and height of the largest, with its border.
std::pair<std::size_t, std::size_t> layer_size(const Scene &scene) {
    int width = 0;
    int height = 0;
    for (const Texture &texture : scene.textures) {
        width = std::max(width, texture.width + 2);
        height = std::max(height, texture.height + 2);
    }
    return {width, height};
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

std::size_t texture_bytes(const Scene &scene, Transfer decode) {
    const auto [width, height] = layer_size(scene);
    return scene.textures.size() * width * height * channels
           * (decode == Transfer::none ? sizeof(std::uint8_t) : sizeof(cl_half));
}

TextureArray::TextureArray(const cl::Context &context, const cl::Device &device, const Scene &scene,
                           Transfer decode) {
    if (device.getInfo<CL_DEVICE_IMAGE_SUPPORT>() == CL_FALSE) {
        throw DeviceError(device.getInfo<CL_DEVICE_NAME>()
                          + " has no images, which textures need; choose another --device");
    }
    for (const Texture &texture : scene.textures) {
        require_size(texture, device.getInfo<CL_DEVICE_IMAGE2D_MAX_WIDTH>(),
                     device.getInfo<CL_DEVICE_IMAGE2D_MAX_HEIGHT>());
    }
    const auto [width, height] = layer_size(scene);
    const std::size_t layers = scene.textures.size();
    const bool decoded = decode != Transfer::none;
    bytes_ = texture_bytes(scene, decode);
    if (layers > device.getInfo<CL_DEVICE_IMAGE_MAX_ARRAY_SIZE>()
        || bytes_ > device.getInfo<CL_DEVICE_MAX_MEM_ALLOC_SIZE>()) {
        throw UserError(fmt::format(
            "{}: {} textures of up to {}x{} texels take {} bytes; this device takes at most {} "
            "textures and {} bytes",
            scene.file.string(), layers, width, height, bytes_,
            device.getInfo<CL_DEVICE_IMAGE_MAX_ARRAY_SIZE>(),
            device.getInfo<CL_DEVICE_MAX_MEM_ALLOC_SIZE>()));
    }
    image_ = decoded ? make_image(context, scene.textures, width, height, CL_HALF_FLOAT,
                                  decoded_codes(decode))
                     : make_image(context, scene.textures, width, height, CL_UNORM_INT8,
                                  undecoded_codes());
}

}  // namespace stagelight
