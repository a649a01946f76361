// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <glm/vec4.hpp>

namespace stagelight {

struct FloatPicture {
    int width = 0, height = 0;
    std::vector<glm::vec4> pixels;  // width * height, row 0 at the top
};

// The picture in another size, no larger either way: each pixel the mean of those that it covers.
FloatPicture rescale(const FloatPicture &picture, int width, int height);

}  // namespace stagelight
