// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

namespace stagelight {

// Linear RGB, row 0 at the top.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<glm::vec3> pixels;  // width * height, row by row

    Image() = default;
    Image(int w, int h) : width(w), height(h), pixels(std::size_t(w) * std::size_t(h)) {}
    glm::vec3 &at(int x, int y) {
        return pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)];
    }
    const glm::vec3 &at(int x, int y) const {
        return pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)];
    }
};

}  // namespace stagelight
