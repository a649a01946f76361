// SPDX-License-Identifier: MIT
// An OpenGL buffer object, as an OpenCL buffer sees it.
#pragma once

#include <cstddef>

#include <CL/cl.h>
#include <CL/cl_gl.h>
#include <epoxy/gl.h>

namespace stagelight {

class GlBuffer {
public:
    // Throws Refusal with the errors of clCreateFromGLBuffer.
    explicit GlBuffer(GLuint name);

    // Throws Refusal: CL_INVALID_GL_OBJECT when it is gone or of another size,
    // CL_INVALID_OPERATION while OpenGL has it mapped.
    void require_unchanged() const;
    void read(std::byte *to) const;
    void write(const std::byte *from) const;

    static constexpr const char *kind = "buffer";
    GLuint name() const { return name_; }
    std::size_t bytes() const { return static_cast<std::size_t>(size_); }
    cl_gl_object_type object() const { return CL_GL_OBJECT_BUFFER; }

private:
    GLuint name_;
    GLsizeiptr size_;
};

}  // namespace stagelight
