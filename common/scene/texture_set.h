// SPDX-License-Identifier: MIT
// Pictures, each read once.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

#include "scene/scene.h"

namespace stagelight {

// No picture wider or higher than this, or with more texels, is read: its header is looked
// at first.
constexpr int largest_texture_size = 16384;
constexpr std::uint64_t largest_texture_area = std::uint64_t{8192} * 8192;

// What lies beyond a picture's left and right edges, and beyond its upper and lower ones.
struct Wraps {
    Wrap u = Wrap::repeat;
    Wrap v = Wrap::repeat;
};

// The index in `textures` of the picture in `file`, which is read and appended
// unless it (the same canonical path, wrapped the same way) is there already. PNG, JPEG, BMP, TGA,
// WebP and PNM pictures become 8-bit RGBA with row 0 at the top. Throws UserError at `where` when
// the file is no such picture, truncated, empty or too large.
int load_texture(std::vector<Texture> &textures, const std::filesystem::path &file,
                 const SourceLocation &where, Wraps wraps = {});

// The index in `textures` of the one whose file is `name` and that is wrapped like that. It is
// appended unless it is there already; `read` makes it unless the file is there, wrapped otherwise.
int texture_once(std::vector<Texture> &textures, const std::filesystem::path &name,
                 const std::function<Texture()> &read, Wraps wraps = {});

}  // namespace stagelight
