// SPDX-License-Identifier: MIT
#include "device/texture_array.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <vector>

#include <CL/cl_half.h>
#include <fmt/format.h>

#include "device/texture_fit.h"
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

// Of a row or column of texels with its border, which one of the texture's own is there.
std::size_t texel_at(std::size_t index_with_border, int size, Wrap wrap) {
    const auto count = static_cast<std::size_t>(size);
    return wrap == Wrap::repeat ? (index_with_border + count - 1) % count
                                : std::clamp(index_with_border, std::size_t{1}, count) - 1;
}

// #region copy_with_border
// The texture with its border, from the upper left corner of that on, in rows of `width` texels.
// Alpha goes the way of the others: nobody reads it here.
template <typename Channel>
void copy_with_border(const Texture &texture, const Codes<Channel> &codes, Channel *corner,
                      std::size_t width) {
    const auto columns = static_cast<std::size_t>(texture.width) + 2;
    const auto rows = static_cast<std::size_t>(texture.height) + 2;
    for (std::size_t y = 0; y < rows; ++y) {
        for (std::size_t x = 0; x < columns; ++x) {
            const std::size_t source = texel_at(y, texture.height, texture.wrap_v)
                                           * static_cast<std::size_t>(texture.width)
                                       + texel_at(x, texture.width, texture.wrap_u);
            std::transform(&texture.texels[source * channels],
                           &texture.texels[source * channels] + channels,
                           corner + (y * width + x) * channels,
                           [&codes](std::uint8_t code) { return codes[code]; });
        }
    }
}
// #endregion copy_with_border

template <typename Channel>
cl::Image2DArray make_image(const cl::Context &context, const std::vector<Texture> &textures,
                            const TexturePages &pages, cl_channel_type type,
                            const Codes<Channel> &codes) {
    std::vector<Channel> texels(pages.texels() * channels);
    for (std::size_t i = 0; i < textures.size(); ++i) {
        const auto &[layer, x, y] = pages.places[i];
        const std::size_t corner = (layer * pages.height + y - 1) * pages.width + x - 1;
        copy_with_border(textures[i], codes, texels.data() + corner * channels, pages.width);
    }
    return {context,
            CL_MEM_READ_ONLY | CL_MEM_COPY_HOST_PTR,
            cl::ImageFormat(CL_RGBA, type),
            pages.layers,
            pages.width,
            pages.height,
            0,
            0,
            texels.data()};
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

TexturePages pages_of(const Scene &scene, const cl::Device &device) {
    return pages_of(scene.textures, texture_limits(device));
}

std::size_t texture_bytes(const Scene &scene, const cl::Device &device, Transfer decode) {
    return pages_of(scene, device).texels() * channels
           * (decode == Transfer::none ? sizeof(std::uint8_t) : sizeof(cl_half));
}

TextureArray::TextureArray(const cl::Context &context, const cl::Device &device, const Scene &scene,
                           Transfer decode) {
    if (device.getInfo<CL_DEVICE_IMAGE_SUPPORT>() == CL_FALSE) {
        throw DeviceError(device.getInfo<CL_DEVICE_NAME>()
                          + " has no images, which textures need; choose another --device");
    }
    const TextureLimits limits = texture_limits(device);
    for (const Texture &texture : scene.textures) {
        require_size(texture, limits.width, limits.height);
    }
    const TexturePages pages = pages_of(scene, device);
    bytes_ = texture_bytes(scene, device, decode);
    if (pages.layers > limits.layers || bytes_ > device.getInfo<CL_DEVICE_MAX_MEM_ALLOC_SIZE>()) {
        throw UserError(fmt::format("{}: {} textures on {} layers of {}x{} texels take {} bytes; "
                                    "this device takes at most {} "
                                    "layers and {} bytes",
                                    scene.file.string(), scene.textures.size(), pages.layers,
                                    pages.width, pages.height, bytes_, limits.layers,
                                    device.getInfo<CL_DEVICE_MAX_MEM_ALLOC_SIZE>()));
    }
    image_ = decode != Transfer::none
                 ? make_image(context, scene.textures, pages, CL_HALF_FLOAT, decoded_codes(decode))
                 : make_image(context, scene.textures, pages, CL_UNORM_INT8, undecoded_codes());
}

}  // namespace stagelight
