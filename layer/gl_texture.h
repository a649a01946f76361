// SPDX-License-Identifier: MIT
// A level of an OpenGL texture, as an OpenCL image sees it.
#pragma once

#include <array>
#include <cstddef>

#include <CL/cl.h>
#include <CL/cl_gl.h>
#include <epoxy/gl.h>

#include "gl_formats.h"

namespace stagelight {

struct TextureTarget {
    GLenum target;  // what the program names: for a cube map a face
    GLenum bound;   // what the texture is bound to
    GLenum query;   // the binding's name for glGetIntegerv
    int dimensions;
    int halving;  // how many of them a mipmap level halves: not the layers of an array
    cl_mem_object_type image;
    cl_gl_object_type object;
};

// Throws Refusal: CL_INVALID_VALUE when the extension does not know the target,
// CL_INVALID_OPERATION for GL_TEXTURE_BUFFER, which the layer does not share.
const TextureTarget &texture_target(GLenum target);

// How a level is stored.
struct TextureLevel {
    GLint width = 0;
    GLint height = 0;
    GLint depth = 0;
    GLint internal = 0;

    bool operator==(const TextureLevel &) const = default;
};

class GlTexture {
public:
    // Throws Refusal with the errors of clCreateFromGLTexture.
    GlTexture(GLenum target, GLint level, GLuint name);

    // Throws Refusal CL_INVALID_GL_OBJECT when the texture is gone or was defined anew.
    void require_unchanged() const;
    void read(std::byte *to) const;
    void write(const std::byte *from) const;

    static constexpr const char *kind = "texture";
    GLuint name() const { return name_; }
    GLint level() const { return level_; }
    const TextureTarget &target() const { return *target_; }
    const Format &format() const { return *format_; }
    std::array<std::size_t, 3> region() const;
    std::size_t bytes() const { return format_->bytes(region()); }
    cl_mem_object_type image() const { return target_->image; }
    cl_gl_object_type object() const { return target_->object; }

private:
    const TextureTarget *target_;
    GLint level_;
    GLuint name_;
    TextureLevel stored_;
    const Format *format_;
};

}  // namespace stagelight
