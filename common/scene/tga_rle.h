// SPDX-License-Identifier: MIT
#pragma once

#include <istream>

namespace stagelight {

enum class TgaRle { none, whole, cut_short };

// Whether the TGA picture in `stream` is run-length encoded, and if so, whether its packets fill
// it: FreeImage takes one that ends early without a word.
TgaRle tga_rle(std::istream &stream);

}  // namespace stagelight
