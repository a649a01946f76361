// SPDX-License-Identifier: MIT
#include "gl_renderbuffer.h"

#include "gl_state.h"
#include "refusal.h"

namespace stagelight {
namespace {

GLuint new_texture() {
    GLuint name = 0;
    glGenTextures(1, &name);
    // A name becomes a texture when it is first bound, and BoundTexture asks for one.
    GLint before = 0;
    glGetIntegerv(GL_TEXTURE_BINDING_2D, &before);
    glBindTexture(GL_TEXTURE_2D, name);
    glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(before));
    return name;
}

// A texture like the renderbuffer: what OpenGL can exchange with client memory bit for bit.
class Copy {
public:
    Copy(GLint width, GLint height, const Format &format, const std::byte *pixels)
        : name_(new_texture()), bound_(GL_TEXTURE_2D, GL_TEXTURE_BINDING_2D, name_) {
        const TightPixels tight(TightPixels::Direction::unpack);
        glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format.internal), width, height, 0,
                     format.order, format.type, pixels);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    }
    ~Copy() { glDeleteTextures(1, &name_); }
    Copy(const Copy &) = delete;
    Copy &operator=(const Copy &) = delete;

    GLuint name() const { return name_; }

private:
    GLuint name_;
    BoundTexture bound_;
};

}  // namespace

GlRenderbuffer::Storage GlRenderbuffer::storage_of(GLuint name) {
    if (glIsRenderbuffer(name) == GL_FALSE) {
        refuse(CL_INVALID_GL_OBJECT, "there is no GL renderbuffer %u", name);
    }
    GLint before = 0;
    glGetIntegerv(GL_RENDERBUFFER_BINDING, &before);
    glBindRenderbuffer(GL_RENDERBUFFER, name);
    Storage storage;
    glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_WIDTH, &storage.width);
    glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_HEIGHT, &storage.height);
    glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_INTERNAL_FORMAT,
                                 &storage.internal);
    glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_SAMPLES, &storage.samples);
    glBindRenderbuffer(GL_RENDERBUFFER, static_cast<GLuint>(before));
    return storage;
}

GlRenderbuffer::GlRenderbuffer(GLuint name) : name_(name), storage_(storage_of(name)) {
    require(storage_.width > 0 && storage_.height > 0, CL_INVALID_GL_OBJECT,
            "the GL renderbuffer has no storage");
    require(storage_.samples == 0, CL_INVALID_OPERATION, "the GL renderbuffer is multisampled");
    require(epoxy_gl_version() >= 43 || epoxy_has_gl_extension("GL_ARB_copy_image"),
            CL_INVALID_OPERATION, "the layer shares renderbuffers from OpenGL 4.3 on");
    format_ = &format_of(static_cast<GLenum>(storage_.internal));
}

void GlRenderbuffer::require_unchanged() const {
    if (storage_of(name_) != storage_) {
        refuse(CL_INVALID_GL_OBJECT, "GL renderbuffer %u got another storage since it was shared",
               name_);
    }
}

std::array<std::size_t, 3> GlRenderbuffer::region() const {
    return {static_cast<std::size_t>(storage_.width), static_cast<std::size_t>(storage_.height), 1};
}

void GlRenderbuffer::read(std::byte *to) const {
    const Copy copy(storage_.width, storage_.height, *format_, nullptr);
    glCopyImageSubData(name_, GL_RENDERBUFFER, 0, 0, 0, 0, copy.name(), GL_TEXTURE_2D, 0, 0, 0, 0,
                       storage_.width, storage_.height, 1);
    const TightPixels tight(TightPixels::Direction::pack);
    glGetTexImage(GL_TEXTURE_2D, 0, format_->order, format_->type, to);
}

void GlRenderbuffer::write(const std::byte *from) const {
    const Copy copy(storage_.width, storage_.height, *format_, from);
    glCopyImageSubData(copy.name(), GL_TEXTURE_2D, 0, 0, 0, 0, name_, GL_RENDERBUFFER, 0, 0, 0, 0,
                       storage_.width, storage_.height, 1);
}

}  // namespace stagelight
