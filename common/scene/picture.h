// SPDX-License-Identifier: MIT
// One picture, decoded and checked.
#pragma once

#include <filesystem>
#include <istream>

#include "scene/scene.h"

namespace stagelight {

// The picture in what is left of `file`, turned as its Exif data says; `name` says in messages
// which it is. Throws
// UserError at `where` when it is no picture of a format that is read here, is cut short, or
// is larger than texture_set.h allows.
Texture read_picture(std::istream &file, const std::filesystem::path &name,
                     const SourceLocation &where);

// Throws UserError unless texture_set.h allows a picture of this size.
void require_texture_size(std::uint64_t width, std::uint64_t height,
                          const std::filesystem::path &name, const SourceLocation &where);

}  // namespace stagelight
