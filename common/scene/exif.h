// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace stagelight {

// How the picture in a JPEG, PNG or WebP file is to be turned, 1 to 8 as in Exif 2.3, section 4.6.4
// ("Orientation"); 1, as it is, where the file does not say.
int exif_orientation(std::string_view bytes);

}  // namespace stagelight
