// SPDX-License-Identifier: MIT
// An OpenGL renderbuffer, as an OpenCL image sees it.
#pragma once

#include <array>
#include <cstddef>

#include <CL/cl.h>
#include <CL/cl_gl.h>
#include <epoxy/gl.h>

#include "gl_formats.h"

namespace stagelight {

class GlRenderbuffer {
public:
    // Throws Refusal with the errors of clCreateFromGLRenderbuffer.
    explicit GlRenderbuffer(GLuint name);

    // Throws Refusal CL_INVALID_GL_OBJECT when it is gone or got another storage.
    void require_unchanged() const;
    void read(std::byte *to) const;
    void write(const std::byte *from) const;

    static constexpr const char *kind = "renderbuffer";
    GLuint name() const { return name_; }
    const Format &format() const { return *format_; }
    std::array<std::size_t, 3> region() const;
    std::size_t bytes() const { return format_->bytes(region()); }
    cl_mem_object_type image() const { return CL_MEM_OBJECT_IMAGE2D; }
    cl_gl_object_type object() const { return CL_GL_OBJECT_RENDERBUFFER; }

private:
    struct Storage {
        GLint width = 0;
        GLint height = 0;
        GLint internal = 0;
        GLint samples = 0;
        bool operator==(const Storage &) const = default;
    };
    static Storage storage_of(GLuint name);

    GLuint name_;
    Storage storage_;
    const Format *format_;
};

}  // namespace stagelight
