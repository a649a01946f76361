// SPDX-License-Identifier: MIT
// Pictures out.
#pragma once

#include <filesystem>

#include "image/image.h"
#include "image/transfer.h"

namespace stagelight {

// By its name's end, in letters of either case.
bool is_exr(const std::filesystem::path &file);

// Throws UserError unless `file` ends in .png or .exr and its folder exists and can be
// written to: asked before anything is rendered.
void require_writable(const std::filesystem::path &file);

// Writes .png (encoded, then rounded to 8 bits; it names its curve, unless that is none) or .exr
// (32-bit float, always linear) to a temporary name beside `file` and renames it, so that a failure
// (a full disk) leaves no half picture and the old one as it was. Throws UserError.
void write_image(const Image &image, const std::filesystem::path &file, Transfer encode,
                 bool split = false);

}  // namespace stagelight
