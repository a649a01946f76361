// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <glm/vec2.hpp>

#include "display/shader.h"
#include "image/transfer.h"

namespace stagelight {

// Shows pictures in the framebuffer of the OpenGL context that is current, in the destructor too.
class Screen {
public:
    Screen();
    ~Screen();
    Screen(const Screen &) = delete;
    Screen &operator=(const Screen &) = delete;

    // Fills the whole framebuffer, of `size` pixels with `color_bits` a channel, with the floating
    // point texture `picture`, whose row 0 is the top: pixel for pixel where the sizes are the
    // same, else filtered linearly. The values are encoded and rounded as write_image does it for
    // PNG. With `split`, a share of the width, those right of a line (image/split.h) are not
    // encoded.
    void draw(unsigned picture, const glm::ivec2 &size, int color_bits, Transfer transfer,
              const std::optional<double> &split = {}) const;

private:
    ShaderProgram program_;
    unsigned no_vertices_ = 0;
    unsigned linear_ = 0;
};

}  // namespace stagelight
