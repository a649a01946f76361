// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace stagelight {

// A BMP as Windows 3 had them, with the picture of this one: with the header of 40 bytes, without
// masks, of 8 bits a channel where there are 16 or 32 bits a pixel. None where it is one already,
// or no BMP. FreeImage refuses the longer headers, and both libraries take some masks for others.
std::optional<std::string> plain_bmp(std::string_view bytes);

}  // namespace stagelight
