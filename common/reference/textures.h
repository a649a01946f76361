// SPDX-License-Identifier: MIT
// Texture coordinates and lookup (paper, section 7; docs/shading.md, "Textures").
#pragma once

#include <cstddef>
#include <numbers>

#include <glm/common.hpp>

#include "image/transfer.h"
#include "reference/rays.h"
#include "scene/scene.h"

namespace stagelight::reference {

// Where a point of the unit sphere lies in a picture wrapped around it. The paper's
// formulas with their slips mended: u turns in the horizontal plane, v spans all of the
// picture, and a rounded 1.0000001 is no NaN at a pole.
template <typename Number> Vec2<Number> sphere_coordinates(const Vec<Number> &q) {
    const Number pi = std::numbers::pi_v<Number>;
    const Number sine = std::clamp(q.y, Number(-1), Number(1));
    return {Number(0.5) + std::atan2(q.x, q.z) / (2 * pi), Number(0.5) - std::asin(sine) / pi};
}

inline int wrapped(int index, int count) {
    return (index % count + count) % count;
}

// The light that a picture's value in [0, 1] stands for. sRGB: IEC 61966-2-1, the straight line
// and the power that it gives, in the precision of Number.
template <typename Number> Number light_of(Transfer curve, Number value) {
    switch (curve) {
    case Transfer::srgb:
    case Transfer::table:
        return value > Number(0.04045L)
                   ? std::pow((value + Number(0.055L)) / Number(1.055L), Number(2.4L))
                   : value / Number(12.92L);
    case Transfer::power:
        return std::pow(value, Number(2.2L));
    case Transfer::none:
        break;
    }
    return value;
}

// The light of one texel, with the picture repeated in both directions.
template <typename Number>
Vec<Number> texel(const Texture &texture, Transfer decode, int column, int row) {
    const auto pixel = std::size_t(wrapped(row, texture.height)) * std::size_t(texture.width)
                       + std::size_t(wrapped(column, texture.width));
    const std::uint8_t *rgba = &texture.texels[4 * pixel];
    const auto light = [decode](std::uint8_t code) {
        return light_of(decode, Number(code) / Number(255));
    };
    return {light(rgba[0]), light(rgba[1]), light(rgba[2])};
}

// The light of the four texels around (u, v), blended linearly.
template <typename Number>
Vec<Number> sample_texture(const Texture &texture, Transfer decode,
                           const Vec2<Number> &coordinates) {
    const Vec2<Number> once = coordinates - glm::floor(coordinates);
    const Vec2<Number> place =
        once * Vec2<Number>(texture.width, texture.height) - Vec2<Number>(Number(0.5));
    const Vec2<Number> corner = glm::floor(place);
    const Vec2<Number> share = place - corner;
    const int column = int(corner.x);
    const int row = int(corner.y);
    const auto row_at = [&](int y) {
        return glm::mix(texel<Number>(texture, decode, column, y),
                        texel<Number>(texture, decode, column + 1, y), share.x);
    };
    return glm::mix(row_at(row), row_at(row + 1), share.y);
}

}  // namespace stagelight::reference
