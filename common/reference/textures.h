// SPDX-License-Identifier: MIT
// Texture coordinates and lookup (paper, section 7; docs/shading.md, "Textures").
#pragma once

#include <cstddef>
#include <numbers>

#include <glm/common.hpp>

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

// One texel, linear, with the picture repeated in both directions.
template <typename Number> Vec<Number> texel(const Texture &texture, int column, int row) {
    const auto pixel = std::size_t(wrapped(row, texture.height)) * std::size_t(texture.width)
                       + std::size_t(wrapped(column, texture.width));
    const std::uint8_t *rgba = &texture.texels[4 * pixel];
    return Vec<Number>(rgba[0], rgba[1], rgba[2]) / Number(255);
}

// The four texels around (u, v), blended linearly.
template <typename Number>
Vec<Number> sample_texture(const Texture &texture, const Vec2<Number> &coordinates) {
    const Vec2<Number> once = coordinates - glm::floor(coordinates);
    const Vec2<Number> place =
        once * Vec2<Number>(texture.width, texture.height) - Vec2<Number>(Number(0.5));
    const Vec2<Number> corner = glm::floor(place);
    const Vec2<Number> share = place - corner;
    const int column = int(corner.x);
    const int row = int(corner.y);
    const auto row_at = [&](int y) {
        return glm::mix(texel<Number>(texture, column, y), texel<Number>(texture, column + 1, y),
                        share.x);
    };
    return glm::mix(row_at(row), row_at(row + 1), share.y);
}

}  // namespace stagelight::reference
