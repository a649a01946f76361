// SPDX-License-Identifier: MIT
// Pictures to show in a window, and what it then shows.
#pragma once

#include <array>
#include <vector>

#include <glm/vec2.hpp>

#include "image/image.h"
#include "image/transfer.h"

namespace stagelight {

// A floating-point texture of OpenGL with a picture.
class PictureTexture {
public:
    explicit PictureTexture(const Image &image);
    ~PictureTexture();
    PictureTexture(const PictureTexture &) = delete;
    PictureTexture &operator=(const PictureTexture &) = delete;

    unsigned id() const { return id_; }

private:
    unsigned id_ = 0;
};

// The steps of a framebuffer's or a PNG's channels, row 0 at the top.
struct Steps {
    int width = 0;
    std::vector<std::array<int, 3>> pixels;

    const std::array<int, 3> &at(int x, int y) const {
        return pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)];
    }
    bool operator==(const Steps &) const = default;
};

// What the framebuffer, of `color_bits` a channel, shows in its upper left corner.
Steps framebuffer(const glm::ivec2 &framebuffer_size, const glm::ivec2 &corner, int color_bits);

// What a PNG of the picture holds.
Steps png(const Image &image, Transfer transfer);

}  // namespace stagelight
