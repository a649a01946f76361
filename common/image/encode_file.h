// SPDX-License-Identifier: MIT
// Pictures as the bytes of a file, in memory: only a whole one is to be put on the disk.
#pragma once

#include <cstdint>
#include <vector>

#include "image/image.h"
#include "image/transfer.h"

namespace stagelight {

// `rgb` has 3 bytes a pixel, row 0 at the top. The file names the curve, unless that is none.
std::vector<std::uint8_t> encode_png(const std::vector<std::uint8_t> &rgb, int width, int height,
                                     Transfer curve);

// 32-bit float, zipped, without a date: the same picture is the same file.
std::vector<std::uint8_t> encode_exr(const Image &image);

}  // namespace stagelight
