// SPDX-License-Identifier: MIT
// OpenGL's rules of completeness, which clCreateFromGLTexture asks for. The texture must be bound.
#pragma once

#include "gl_texture.h"

namespace stagelight {

TextureLevel stored_level(const TextureTarget &target, GLint level);

// Throws Refusal CL_INVALID_MIP_LEVEL when the level is below the base level or above the last one
// that the texture's size allows (OpenGL 4.6 section 8.14.3: q).
void require_level(const TextureTarget &target, GLint level);

// Throws Refusal CL_INVALID_GL_OBJECT when the texture is incomplete (OpenGL 4.6 section 8.17).
// `is_integer` says whether its internal format is.
void require_complete(const TextureTarget &target, bool is_integer);

}  // namespace stagelight
