// SPDX-License-Identifier: MIT
#include "scene/texture_alpha.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <tuple>

namespace stagelight {
namespace {

using Texel = std::array<double, 4>;

Texel texel_at(const Texture &texture, int x, int y) {
    const auto wrapped = [](int i, int size) {
        return static_cast<std::size_t>((i + size) % size);
    };
    const std::uint8_t *texel =
        &texture.texels[4
                        * (wrapped(y, texture.height) * static_cast<std::size_t>(texture.width)
                           + wrapped(x, texture.width))];
    return {double(texel[0]), double(texel[1]), double(texel[2]), double(texel[3])};
}

// Between the four texels around the place, which is (0, 0) to (1, 1).
Texel sample(const Texture &texture, double u, double v) {
    const double x = u * texture.width - 0.5, y = v * texture.height - 0.5;
    const int left = static_cast<int>(std::floor(x)), top = static_cast<int>(std::floor(y));
    const double right = x - left, bottom = y - top;
    Texel sum{};
    for (const auto &[dx, dy, weight] :
         {std::tuple{0, 0, (1 - right) * (1 - bottom)}, std::tuple{1, 0, right * (1 - bottom)},
          std::tuple{0, 1, (1 - right) * bottom}, std::tuple{1, 1, right * bottom}}) {
        if (weight > 0) {
            const Texel texel = texel_at(texture, left + dx, top + dy);
            for (std::size_t i = 0; i < 4; ++i) {
                sum[i] += weight * texel[i];
            }
        }
    }
    return sum;
}

std::uint8_t rounded(double value) {
    return static_cast<std::uint8_t>(std::clamp(std::lround(value), 0L, 255L));
}

}  // namespace

AlphaRange alpha_range(const Texture &texture) {
    AlphaRange range;
    int greatest = 0;
    for (std::size_t i = 3; i < texture.texels.size(); i += 4) {
        const int alpha = texture.texels[i];
        range.least = std::min(range.least, alpha);
        greatest = std::max(greatest, alpha);
        range.has_partial = range.has_partial || (alpha > 0 && alpha < 255);
    }
    return greatest > 0 ? range : AlphaRange{};
}

Texture with_alpha(const Texture &color, const Texture &mask) {
    const bool has_alpha = alpha_range(mask).least < 255;
    Texture texture = color;
    texture.width = std::max(color.width, mask.width);
    texture.height = std::max(color.height, mask.height);
    texture.texels.clear();
    for (int y = 0; y < texture.height; ++y) {
        for (int x = 0; x < texture.width; ++x) {
            const double u = (x + 0.5) / texture.width, v = (y + 0.5) / texture.height;
            const Texel c = sample(color, u, v);
            const Texel m = sample(mask, u, v);
            const double luminance = 0.2126 * m[0] + 0.7152 * m[1] + 0.0722 * m[2];
            texture.texels.insert(texture.texels.end(),
                                  {rounded(c[0]), rounded(c[1]), rounded(c[2]),
                                   rounded(has_alpha ? m[3] : luminance)});
        }
    }
    return texture;
}

}  // namespace stagelight
