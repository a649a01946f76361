// SPDX-License-Identifier: MIT
// Texture coordinates and lookup (paper, section 7; docs/shading.md, "Textures").
#pragma once

#include <algorithm>
#include <cmath>
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

inline int repeated(int index, int count) {
    return (index % count + count) % count;
}

// Beyond the edges, as `wrap` has it.
inline int wrapped(int index, int count, Wrap wrap) {
    switch (wrap) {
    case Wrap::clamp:
        return std::clamp(index, 0, count - 1);
    case Wrap::mirror: {
        const int in_two = repeated(index, 2 * count);  // the picture and its mirror image
        return std::min(in_two, 2 * count - 1 - in_two);
    }
    case Wrap::repeat:
        break;
    }
    return repeated(index, count);
}

// A coordinate near the picture, where it looks the same.
template <typename Number> Number near_picture(Number coordinate, Wrap wrap) {
    return wrap == Wrap::clamp ? std::clamp(coordinate, Number(-1), Number(2))
                               : coordinate - 2 * std::floor(coordinate / 2);
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

// One texel's red, green, blue and alpha; beyond the edges too.
inline const std::uint8_t *texel_of(const Texture &texture, int column, int row) {
    const auto pixel =
        std::size_t(wrapped(row, texture.height, texture.wrap_v)) * std::size_t(texture.width)
        + std::size_t(wrapped(column, texture.width, texture.wrap_u));
    return &texture.texels[4 * pixel];
}

// The light of one texel.
template <typename Number>
Vec<Number> texel(const Texture &texture, Transfer decode, int column, int row) {
    const std::uint8_t *rgba = texel_of(texture, column, row);
    const auto light = [decode](std::uint8_t code) {
        return light_of(decode, Number(code) / Number(255));
    };
    return {light(rgba[0]), light(rgba[1]), light(rgba[2])};
}

// What `at(column, row)` says of the four texels around (u, v), blended linearly. Where all are the
// same, so is the result, to the bit.
template <typename Number, typename At>
auto blend_texels(const Texture &texture, const Vec2<Number> &coordinates, At at) {
    const Vec2<Number> near(near_picture(coordinates.x, texture.wrap_u),
                            near_picture(coordinates.y, texture.wrap_v));
    const Vec2<Number> place =
        near * Vec2<Number>(texture.width, texture.height) - Vec2<Number>(Number(0.5));
    const Vec2<Number> corner = glm::floor(place);
    const Vec2<Number> share = place - corner;
    const int column = int(corner.x);
    const int row = int(corner.y);
    const auto between = [](const auto &a, const auto &b, Number by) { return a + by * (b - a); };
    const auto row_at = [&](int y) { return between(at(column, y), at(column + 1, y), share.x); };
    return between(row_at(row), row_at(row + 1), share.y);
}

template <typename Number>
Vec<Number> sample_texture(const Texture &texture, Transfer decode,
                           const Vec2<Number> &coordinates) {
    return blend_texels(texture, coordinates, [&](int column, int row) {
        return texel<Number>(texture, decode, column, row);
    });
}

// Never decoded: it is a share, and no light.
template <typename Number>
Number sample_alpha(const Texture &texture, const Vec2<Number> &coordinates) {
    return blend_texels(
               texture, coordinates,
               [&](int column, int row) { return Number(texel_of(texture, column, row)[3]); })
           / Number(255);
}

}  // namespace stagelight::reference
