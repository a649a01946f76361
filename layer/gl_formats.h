// SPDX-License-Identifier: MIT
// Which OpenCL image format an internal format of OpenGL is.
#pragma once

#include <array>
#include <cstddef>

#include <CL/cl.h>
#include <epoxy/gl.h>

namespace stagelight {

struct Format {
    GLenum internal;
    GLenum order;        // GL_RGBA, GL_RG_INTEGER …: with `type`, how OpenGL hands pixels out
    GLenum type;         // such that no bit is lost
    cl_image_format cl;  // the same memory, for OpenCL
    std::size_t pixel;   // bytes

    std::size_t bytes(const std::array<std::size_t, 3> &region) const {
        return region[0] * region[1] * region[2] * pixel;
    }
    bool is_integer() const { return order != GL_RGBA && order != GL_RG && order != GL_RED; }
};

// Throws Refusal CL_INVALID_IMAGE_FORMAT_DESCRIPTOR when no image format stands for it.
const Format &format_of(GLenum internal);

}  // namespace stagelight
