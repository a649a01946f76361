// SPDX-License-Identifier: MIT
// The OpenGL texture that holds the picture: linear light, row 0 at the top.
#pragma once

#include <cstddef>
#include <stdexcept>

#include "display/gl.h"
#include "image/image.h"

namespace stagelight {

// Why a display path does not work: the pipeline says so, and tries the next.
class PresenterLost : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

// Half precision is half the bytes, and 11 bits of each value.
enum class TextureFormat { rgba16f, rgba32f };

class FloatTexture {
public:
    // Pixels. Needs a current context, as all here. Throws PresenterLost for a size that is too
    // large.
    FloatTexture(TextureFormat format, int width, int height);
    ~FloatTexture();
    FloatTexture(FloatTexture &&other) noexcept;
    FloatTexture &operator=(FloatTexture &&other) noexcept;

    GLuint id() const { return id_; }
    int width() const { return width_; }
    int height() const { return height_; }
    std::size_t bytes() const;

    // Read back with glReadPixels.
    Image read() const;

private:
    TextureFormat format_;
    int width_;
    int height_;
    GLuint id_ = 0;
};

}  // namespace stagelight
