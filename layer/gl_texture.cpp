// SPDX-License-Identifier: MIT
#include "gl_texture.h"

#include "gl_completeness.h"
#include "gl_state.h"
#include "refusal.h"

namespace stagelight {
namespace {

constexpr TextureTarget face(GLenum target) {
    return {target, GL_TEXTURE_CUBE_MAP,   GL_TEXTURE_BINDING_CUBE_MAP, 2,
            2,      CL_MEM_OBJECT_IMAGE2D, CL_GL_OBJECT_TEXTURE2D};
}

// clCreateFromGLTexture lists the targets and what becomes of each.
constexpr TextureTarget targets[] = {
    {GL_TEXTURE_2D, GL_TEXTURE_2D, GL_TEXTURE_BINDING_2D, 2, 2, CL_MEM_OBJECT_IMAGE2D,
     CL_GL_OBJECT_TEXTURE2D},
    {GL_TEXTURE_RECTANGLE, GL_TEXTURE_RECTANGLE, GL_TEXTURE_BINDING_RECTANGLE, 2, 0,
     CL_MEM_OBJECT_IMAGE2D, CL_GL_OBJECT_TEXTURE2D},
    face(GL_TEXTURE_CUBE_MAP_POSITIVE_X),
    face(GL_TEXTURE_CUBE_MAP_NEGATIVE_X),
    face(GL_TEXTURE_CUBE_MAP_POSITIVE_Y),
    face(GL_TEXTURE_CUBE_MAP_NEGATIVE_Y),
    face(GL_TEXTURE_CUBE_MAP_POSITIVE_Z),
    face(GL_TEXTURE_CUBE_MAP_NEGATIVE_Z),
    {GL_TEXTURE_1D, GL_TEXTURE_1D, GL_TEXTURE_BINDING_1D, 1, 1, CL_MEM_OBJECT_IMAGE1D,
     CL_GL_OBJECT_TEXTURE1D},
    {GL_TEXTURE_1D_ARRAY, GL_TEXTURE_1D_ARRAY, GL_TEXTURE_BINDING_1D_ARRAY, 2, 1,
     CL_MEM_OBJECT_IMAGE1D_ARRAY, CL_GL_OBJECT_TEXTURE1D_ARRAY},
    {GL_TEXTURE_2D_ARRAY, GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BINDING_2D_ARRAY, 3, 2,
     CL_MEM_OBJECT_IMAGE2D_ARRAY, CL_GL_OBJECT_TEXTURE2D_ARRAY},
    {GL_TEXTURE_3D, GL_TEXTURE_3D, GL_TEXTURE_BINDING_3D, 3, 3, CL_MEM_OBJECT_IMAGE3D,
     CL_GL_OBJECT_TEXTURE3D},
};

// GL_RGBA without sizes is in the extension's table where OpenGL chose 8 bits, as it does.
GLenum sized(const TextureTarget &target, GLint level, GLint internal) {
    GLint bits = 0;
    glGetTexLevelParameteriv(target.target, level, GL_TEXTURE_ALPHA_SIZE, &bits);
    return internal == GL_RGBA && bits == 8 ? GL_RGBA8 : static_cast<GLenum>(internal);
}

}  // namespace

const TextureTarget &texture_target(GLenum target) {
    require(target != GL_TEXTURE_BUFFER, CL_INVALID_OPERATION,
            "the layer does not share buffer textures: share their buffer");
    for (const TextureTarget &each : targets) {
        if (each.target == target) {
            return each;
        }
    }
    refuse(CL_INVALID_VALUE, "%#06x is no texture target that can be shared", target);
}

GlTexture::GlTexture(GLenum target, GLint level, GLuint name)
    : target_(&texture_target(target)), level_(level), name_(name) {
    const BoundTexture bound(target_->bound, target_->query, name);
    require_level(*target_, level);
    stored_ = stored_level(*target_, level);
    require(stored_.width > 0 && stored_.height > 0 && stored_.depth > 0, CL_INVALID_GL_OBJECT,
            "the mipmap level of the GL texture is not defined");
    format_ = &format_of(sized(*target_, level, stored_.internal));
    require_complete(*target_, format_->is_integer());
}

void GlTexture::require_unchanged() const {
    const BoundTexture bound(target_->bound, target_->query, name_);
    if (stored_level(*target_, level_) != stored_) {
        refuse(CL_INVALID_GL_OBJECT, "GL texture %u was defined anew since it was shared", name_);
    }
}

std::array<std::size_t, 3> GlTexture::region() const {
    return {static_cast<std::size_t>(stored_.width), static_cast<std::size_t>(stored_.height),
            static_cast<std::size_t>(stored_.depth)};
}

void GlTexture::read(std::byte *to) const {
    const BoundTexture bound(target_->bound, target_->query, name_);
    const TightPixels tight(TightPixels::Direction::pack);
    glGetTexImage(target_->target, level_, format_->order, format_->type, to);
}

void GlTexture::write(const std::byte *from) const {
    const BoundTexture bound(target_->bound, target_->query, name_);
    const TightPixels tight(TightPixels::Direction::unpack);
    const auto [width, height, depth, internal] = stored_;
    switch (target_->dimensions) {
    case 1:
        return glTexSubImage1D(target_->target, level_, 0, width, format_->order, format_->type,
                               from);
    case 2:
        return glTexSubImage2D(target_->target, level_, 0, 0, width, height, format_->order,
                               format_->type, from);
    default:
        return glTexSubImage3D(target_->target, level_, 0, 0, 0, width, height, depth,
                               format_->order, format_->type, from);
    }
}

}  // namespace stagelight
