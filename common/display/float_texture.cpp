// SPDX-License-Identifier: MIT
#include "display/float_texture.h"

#include <utility>

#include <fmt/format.h>

namespace stagelight {

FloatTexture::FloatTexture(TextureFormat format, int width, int height)
    : format_(format), width_(width), height_(height) {
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    if (width > largest || height > largest) {
        throw PresenterLost(
            fmt::format("{}x{} pixels, and OpenGL's textures have at most {} each way", width,
                        height, largest));
    }
    glGenTextures(1, &id_);
    glBindTexture(GL_TEXTURE_2D, id_);
    glTexImage2D(GL_TEXTURE_2D, 0, format == TextureFormat::rgba16f ? GL_RGBA16F : GL_RGBA32F,
                 width, height, 0, GL_RGBA, GL_FLOAT, nullptr);
    // One level alone: without these OpenCL takes the texture for incomplete.
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

FloatTexture::~FloatTexture() {
    glDeleteTextures(1, &id_);
}

FloatTexture::FloatTexture(FloatTexture &&other) noexcept
    : format_(other.format_), width_(other.width_), height_(other.height_),
      id_(std::exchange(other.id_, 0)) {}

FloatTexture &FloatTexture::operator=(FloatTexture &&other) noexcept {
    format_ = other.format_;
    width_ = other.width_;
    height_ = other.height_;
    std::swap(id_, other.id_);
    return *this;
}

std::size_t FloatTexture::bytes() const {
    const std::size_t texel = format_ == TextureFormat::rgba16f ? 8 : 16;
    return static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) * texel;
}

Image FloatTexture::read() const {
    Image image(width_, height_);
    GLuint framebuffer = 0;
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, id_, 0);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width_, height_, GL_RGB, GL_FLOAT, image.pixels.data());
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    glDeleteFramebuffers(1, &framebuffer);
    return image;
}

}  // namespace stagelight
