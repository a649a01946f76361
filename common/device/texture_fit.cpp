// SPDX-License-Identifier: MIT
#include "device/texture_fit.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include <fmt/format.h>

#include "image/rescale.h"

namespace stagelight {
namespace {

// Alpha is no light.
FloatPicture light_of(const Texture &texture, Transfer decode) {
    FloatPicture picture{texture.width, texture.height, {}};
    picture.pixels.reserve(texture.texels.size() / 4);
    for (std::size_t i = 0; i < texture.texels.size(); i += 4) {
        glm::vec4 pixel;
        for (int channel = 0; channel < 4; ++channel) {
            const float value =
                static_cast<float>(texture.texels[i + static_cast<std::size_t>(channel)]) / 255;
            pixel[channel] = channel < 3 ? stagelight::decode(decode, value) : value;
        }
        picture.pixels.push_back(pixel);
    }
    return picture;
}

std::vector<std::uint8_t> texels_of(const FloatPicture &picture, Transfer decode) {
    std::vector<std::uint8_t> texels;
    texels.reserve(4 * picture.pixels.size());
    for (const glm::vec4 &pixel : picture.pixels) {
        for (int channel = 0; channel < 4; ++channel) {
            const float value = channel < 3 ? encode(decode, pixel[channel])
                                            : std::clamp(pixel[channel], 0.0F, 1.0F);
            texels.push_back(static_cast<std::uint8_t>(std::lround(255 * value)));
        }
    }
    return texels;
}

}  // namespace

std::vector<std::string> fit_textures(Scene &scene, const TextureLimits &limits, Transfer decode) {
    std::vector<std::string> lines;
    constexpr std::size_t border = 2;
    if (std::min(limits.width, limits.height) <= border) {
        return lines;  // no images at all, which is told elsewhere
    }
    for (Texture &texture : scene.textures) {
        const int width = std::min(texture.width, static_cast<int>(limits.width - border));
        const int height = std::min(texture.height, static_cast<int>(limits.height - border));
        if (width == texture.width && height == texture.height) {
            continue;
        }
        lines.push_back(fmt::format("{}: {} has {}x{} texels, rescaled to {}x{}: this device takes "
                                    "no larger image",
                                    to_string(texture.where), texture.file.string(), texture.width,
                                    texture.height, width, height));
        texture.texels = texels_of(rescale(light_of(texture, decode), width, height), decode);
        texture.width = width;
        texture.height = height;
    }
    return lines;
}

TextureLimits texture_limits(const cl::Device &device) {
    // A Material has 16 bits for a layer (kernels/scene_types.h).
    constexpr std::size_t most_layers = std::numeric_limits<cl_short>::max();
    return {device.getInfo<CL_DEVICE_IMAGE2D_MAX_WIDTH>(),
            device.getInfo<CL_DEVICE_IMAGE2D_MAX_HEIGHT>(),
            std::min(device.getInfo<CL_DEVICE_IMAGE_MAX_ARRAY_SIZE>(), most_layers)};
}

}  // namespace stagelight
