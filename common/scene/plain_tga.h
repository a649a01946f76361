// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace stagelight {

// A TGA with the picture of this one that both libraries read, or none where this one is. Grey with
// alpha, which FreeImage refuses, and colour maps that start at another entry than 0 or have
// entries of 16 bits, become 32 bits a pixel. What goes from right to left is said to go from left
// to right, as stb_image takes it anyway: it is to be mirrored.
std::optional<std::string> plain_tga(std::string_view bytes);

// Whether the rows of a TGA go from right to left.
bool is_mirrored_tga(std::string_view bytes);

}  // namespace stagelight
