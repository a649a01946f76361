// SPDX-License-Identifier: MIT
// Golden pictures, in and out, through OpenImageIO.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "image/image.h"

namespace stagelight {

// A golden picture: 16-bit float EXR with the channels R, G, B, edge.
struct Golden {
    Image image;
    std::vector<std::uint8_t> edge;  // 1 where the pixel is on an edge; width * height
};

void write_golden(const Golden &golden, const std::filesystem::path &file);

// Throws UserError when the file is missing, truncated, without those four channels, or has a NaN.
Golden read_golden(const std::filesystem::path &file);

}  // namespace stagelight
