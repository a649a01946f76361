// SPDX-License-Identifier: MIT
// The alpha of textures: how much of them is there.
#pragma once

#include "scene/scene.h"

namespace stagelight {

struct AlphaRange {
    int least = 255;
    bool has_partial = false;  // neither 0 nor 255
};

// A texture whose alpha is 0 all over is taken for one that has none: writers of 32-bit BMP and TGA
// leave the fourth byte empty.
AlphaRange alpha_range(const Texture &texture);

// `color` with what `mask` says for its alpha: the mask's own, or if it has none, its luminance. As
// large as the larger of both, along each side.
Texture with_alpha(const Texture &color, const Texture &mask);

}  // namespace stagelight
