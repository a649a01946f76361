// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "display/shader.h"

namespace stagelight {

// Text over what the framebuffer shows: the keys, or a kernel's build log. For the OpenGL
// context that is current, in the destructor too.
class Overlay {
public:
    Overlay();
    ~Overlay();
    Overlay(const Overlay &) = delete;
    Overlay &operator=(const Overlay &) = delete;

    // On a dark panel in the upper left corner of a framebuffer of `size` pixels; `content_scale`
    // as the window has it. Letters shrink until all fits or they get too small, then what does
    // not fit is left out. Characters that are not ASCII show as '?'.
    void draw(const std::vector<std::string> &lines, const glm::ivec2 &size,
              float content_scale) const;

private:
    ShaderProgram program_;
    unsigned vertex_array_ = 0;
    unsigned vertices_ = 0;
};

}  // namespace stagelight
