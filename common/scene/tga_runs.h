// SPDX-License-Identifier: MIT
#pragma once

#include <istream>

namespace stagelight {

enum class TgaRuns { none, whole, cut_short };

// Whether the TGA picture in `stream` is coded in runs, and if so, whether they fill it: FreeImage
// takes one that ends early without a word.
TgaRuns tga_runs(std::istream &stream);

}  // namespace stagelight
