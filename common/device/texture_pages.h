// SPDX-License-Identifier: MIT
// Where each texture lies in an array of images, all of whose layers are of one size.
#pragma once

#include <cstddef>
#include <vector>

#include "scene/scene.h"

namespace stagelight {

struct TexturePlace {
    std::size_t layer = 0;
    std::size_t x = 0, y = 0;  // of the first texel: the border is around it
};

struct TexturePages {
    std::size_t width = 0, height = 0, layers = 0;
    std::vector<TexturePlace> places;  // of each texture

    std::size_t texels() const { return width * height * layers; }
};

// The largest array that a device takes.
struct TextureLimits {
    std::size_t width = 0, height = 0, layers = 0;
};

// Small textures share a layer. Each has a border of one texel all around, which no other touches.
// Where they fit the limits in some way that is tried, the result does; of these ways it is that of
// the fewest texels, and of those of the lowest layers. The same textures always get the same
// places.
TexturePages pages_of(const std::vector<Texture> &textures, const TextureLimits &limits);

}  // namespace stagelight
