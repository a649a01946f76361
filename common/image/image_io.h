// SPDX-License-Identifier: MIT
// Pictures out and goldens in, through OpenImageIO.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "image/image.h"
#include "image/transfer.h"

namespace stagelight {

// Throws UserError unless `file` ends in .png or .exr and its folder exists and can be
// written to: asked before anything is rendered.
void require_writable(const std::filesystem::path &file);

// Writes .png (encoded, then rounded to 8 bits; it names its curve, unless that is none) or .exr
// (32-bit float, always linear) to a temporary name beside `file` and renames it, so that a failure
// (a full disk) leaves no half picture and the old one as it was. Throws UserError.
void write_image(const Image &image, const std::filesystem::path &file, Transfer encode,
                 bool split = false);

// A golden picture: 16-bit float EXR with the channels R, G, B, edge.
struct Golden {
    Image image;
    std::vector<std::uint8_t> edge;  // 1 where the pixel is on an edge; width * height
};

void write_golden(const Golden &golden, const std::filesystem::path &file);

// Throws UserError when the file is missing, truncated, without those four channels, or has a NaN.
Golden read_golden(const std::filesystem::path &file);

}  // namespace stagelight
