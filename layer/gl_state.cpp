// SPDX-License-Identifier: MIT
#include "gl_state.h"

#include "refusal.h"

namespace stagelight {
namespace {

GLuint binding(GLenum query) {
    GLint name = 0;
    glGetIntegerv(query, &name);
    return static_cast<GLuint>(name);
}

constexpr GLenum pack_settings[] = {GL_PACK_ALIGNMENT,    GL_PACK_SWAP_BYTES, GL_PACK_LSB_FIRST,
                                    GL_PACK_ROW_LENGTH,   GL_PACK_SKIP_ROWS,  GL_PACK_SKIP_PIXELS,
                                    GL_PACK_IMAGE_HEIGHT, GL_PACK_SKIP_IMAGES};
constexpr GLenum unpack_settings[] = {
    GL_UNPACK_ALIGNMENT, GL_UNPACK_SWAP_BYTES,  GL_UNPACK_LSB_FIRST,    GL_UNPACK_ROW_LENGTH,
    GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS, GL_UNPACK_IMAGE_HEIGHT, GL_UNPACK_SKIP_IMAGES};

const GLenum *settings(TightPixels::Direction direction) {
    return direction == TightPixels::Direction::pack ? pack_settings : unpack_settings;
}

}  // namespace

BoundBuffer::BoundBuffer(GLenum target, GLenum query, GLuint name)
    : target_(target), before_(binding(query)) {
    glBindBuffer(target, name);
}

BoundTexture::BoundTexture(GLenum target, GLenum query, GLuint name)
    : target_(target), before_(binding(query)) {
    if (glIsTexture(name) == GL_FALSE) {
        refuse(CL_INVALID_GL_OBJECT, "there is no GL texture %u", name);
    }
    glBindTexture(target, name);
    if (binding(query) != name) {
        glGetError();  // that of the failed binding
        refuse(CL_INVALID_GL_OBJECT, "GL texture %u is not of the target %#06x", name, target);
    }
}

TightPixels::TightPixels(Direction direction)
    : direction_(direction),
      no_buffer_(direction == Direction::pack
                     ? BoundBuffer(GL_PIXEL_PACK_BUFFER, GL_PIXEL_PACK_BUFFER_BINDING, 0)
                     : BoundBuffer(GL_PIXEL_UNPACK_BUFFER, GL_PIXEL_UNPACK_BUFFER_BINDING, 0)) {
    for (std::size_t i = 0; i < before_.size(); ++i) {
        glGetIntegerv(settings(direction)[i], &before_[i]);
        glPixelStorei(settings(direction)[i], i == 0 ? 1 : 0);  // the alignment comes first
    }
}

TightPixels::~TightPixels() {
    for (std::size_t i = 0; i < before_.size(); ++i) {
        glPixelStorei(settings(direction_)[i], before_[i]);
    }
}

}  // namespace stagelight
