// SPDX-License-Identifier: MIT
#include "gl_buffer.h"

#include "gl_state.h"
#include "refusal.h"

namespace stagelight {
namespace {

BoundBuffer bound_for_reading(GLuint name) {
    return {GL_COPY_READ_BUFFER, GL_COPY_READ_BUFFER_BINDING, name};
}

GLint64 parameter(GLuint name, GLenum parameter) {
    const BoundBuffer bound = bound_for_reading(name);
    GLint64 value = 0;
    glGetBufferParameteri64v(GL_COPY_READ_BUFFER, parameter, &value);
    return value;
}

GLsizeiptr size_of(GLuint name) {
    if (glIsBuffer(name) == GL_FALSE) {
        refuse(CL_INVALID_GL_OBJECT, "there is no GL buffer %u", name);
    }
    return static_cast<GLsizeiptr>(parameter(name, GL_BUFFER_SIZE));
}

}  // namespace

GlBuffer::GlBuffer(GLuint name) : name_(name), size_(size_of(name)) {
    require(size_ > 0, CL_INVALID_GL_OBJECT, "the GL buffer has no data store");
}

void GlBuffer::require_unchanged() const {
    if (size_of(name_) != size_) {
        refuse(CL_INVALID_GL_OBJECT, "GL buffer %u got another size since it was shared", name_);
    }
    const bool persistent = (parameter(name_, GL_BUFFER_ACCESS_FLAGS) & GL_MAP_PERSISTENT_BIT) != 0;
    require(parameter(name_, GL_BUFFER_MAPPED) == GL_FALSE || persistent, CL_INVALID_OPERATION,
            "the GL buffer is mapped: glUnmapBuffer first");
}

void GlBuffer::read(std::byte *to) const {
    const BoundBuffer bound = bound_for_reading(name_);
    glGetBufferSubData(GL_COPY_READ_BUFFER, 0, size_, to);
}

// By way of another buffer: glBufferSubData is refused on a store that glBufferStorage made.
void GlBuffer::write(const std::byte *from) const {
    GLuint staging = 0;
    glGenBuffers(1, &staging);
    {
        const BoundBuffer source = bound_for_reading(staging);
        const BoundBuffer destination(GL_COPY_WRITE_BUFFER, GL_COPY_WRITE_BUFFER_BINDING, name_);
        glBufferData(GL_COPY_READ_BUFFER, size_, from, GL_STREAM_COPY);
        glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0, size_);
    }
    glDeleteBuffers(1, &staging);
}

}  // namespace stagelight
