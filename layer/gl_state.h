// SPDX-License-Identifier: MIT
// Guards that leave the program's OpenGL state as they found it. A context of OpenGL 3.2 or later
// must be current.
#pragma once

#include <array>

#include <epoxy/gl.h>

namespace stagelight {

class BoundBuffer {
public:
    // `query` is the name that glGetIntegerv knows the binding by.
    BoundBuffer(GLenum target, GLenum query, GLuint name);
    ~BoundBuffer() { glBindBuffer(target_, before_); }
    BoundBuffer(const BoundBuffer &) = delete;
    BoundBuffer &operator=(const BoundBuffer &) = delete;

private:
    GLenum target_;
    GLuint before_;
};

class BoundTexture {
public:
    // Throws Refusal CL_INVALID_GL_OBJECT when `name` is no texture of that target.
    BoundTexture(GLenum target, GLenum query, GLuint name);
    ~BoundTexture() { glBindTexture(target_, before_); }
    BoundTexture(const BoundTexture &) = delete;
    BoundTexture &operator=(const BoundTexture &) = delete;

private:
    GLenum target_;
    GLuint before_;
};

// Pixels go between OpenGL and client memory without gaps and in the machine's byte order.
class TightPixels {
public:
    enum class Direction { pack, unpack };  // out of OpenGL, into it
    explicit TightPixels(Direction direction);
    ~TightPixels();
    TightPixels(const TightPixels &) = delete;
    TightPixels &operator=(const TightPixels &) = delete;

private:
    static constexpr int setting_count = 8;
    Direction direction_;
    std::array<GLint, setting_count> before_{};
    BoundBuffer no_buffer_;
};

}  // namespace stagelight
