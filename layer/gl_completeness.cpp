// SPDX-License-Identifier: MIT
#include "gl_completeness.h"

#include <algorithm>
#include <bit>
#include <vector>

#include "refusal.h"

namespace stagelight {
namespace {

GLint parameter(const TextureTarget &target, GLenum name) {
    GLint value = 0;
    glGetTexParameteriv(target.bound, name, &value);
    return value;
}

GLint level_parameter(const TextureTarget &target, GLint level, GLenum name) {
    GLint value = 0;
    glGetTexLevelParameteriv(target.target, level, name, &value);
    return value;
}

GLint halved(GLint size, GLint times) {
    return std::max(size >> times, 1);
}

// What level `above` levels over the base one must be like.
TextureLevel expected(const TextureTarget &target, TextureLevel base, GLint above) {
    base.width = halved(base.width, target.halving > 0 ? above : 0);
    base.height = halved(base.height, target.halving > 1 ? above : 0);
    base.depth = halved(base.depth, target.halving > 2 ? above : 0);
    return base;
}

// The levels that glTexStorage made, or 0.
GLint immutable_levels(const TextureTarget &target) {
    return epoxy_gl_version() >= 43 ? parameter(target, GL_TEXTURE_IMMUTABLE_LEVELS) : 0;
}

GLint base_level(const TextureTarget &target) {
    return parameter(target, GL_TEXTURE_BASE_LEVEL);
}

GLint last_level(const TextureTarget &target) {
    const GLint base = base_level(target);
    const TextureLevel at_base = stored_level(target, base);
    GLint size = 1;
    size = std::max(size, target.halving > 0 ? at_base.width : 1);
    size = std::max(size, target.halving > 1 ? at_base.height : 1);
    size = std::max(size, target.halving > 2 ? at_base.depth : 1);
    const GLint by_size =
        base + static_cast<GLint>(std::bit_width(static_cast<unsigned>(size))) - 1;
    const GLint last = std::min(by_size, parameter(target, GL_TEXTURE_MAX_LEVEL));
    const GLint stored = immutable_levels(target);
    return stored > 0 ? std::min(last, stored - 1) : last;
}

// All six of a cube map: it must be complete as a whole.
std::vector<TextureTarget> faces(const TextureTarget &target) {
    std::vector<TextureTarget> all{target};
    for (GLenum i = 0; target.bound == GL_TEXTURE_CUBE_MAP && i < 6; ++i) {
        all.push_back(target);
        all.back().target = GL_TEXTURE_CUBE_MAP_POSITIVE_X + i;
    }
    return all;
}

}  // namespace

TextureLevel stored_level(const TextureTarget &target, GLint level) {
    return {level_parameter(target, level, GL_TEXTURE_WIDTH),
            level_parameter(target, level, GL_TEXTURE_HEIGHT),
            level_parameter(target, level, GL_TEXTURE_DEPTH),
            level_parameter(target, level, GL_TEXTURE_INTERNAL_FORMAT)};
}

void require_level(const TextureTarget &target, GLint level) {
    require(level >= base_level(target) && level <= last_level(target), CL_INVALID_MIP_LEVEL,
            "the GL texture has no such mipmap level");
}

void require_complete(const TextureTarget &target, bool is_integer) {
    const GLint smaller = parameter(target, GL_TEXTURE_MIN_FILTER);
    const GLint larger = parameter(target, GL_TEXTURE_MAG_FILTER);
    const bool mipmapped = smaller != GL_NEAREST && smaller != GL_LINEAR;
    const bool nearest =
        larger == GL_NEAREST && (smaller == GL_NEAREST || smaller == GL_NEAREST_MIPMAP_NEAREST);
    require(!is_integer || nearest, CL_INVALID_GL_OBJECT,
            "the GL texture is incomplete: one of integers needs the filters GL_NEAREST");
    const GLint base = base_level(target);
    const GLint last = mipmapped ? last_level(target) : base;
    const TextureLevel at_base = stored_level(target, base);
    for (const TextureTarget &each : faces(target)) {
        for (GLint level = base; level <= last; ++level) {
            require(stored_level(each, level) == expected(target, at_base, level - base),
                    CL_INVALID_GL_OBJECT,
                    "the GL texture is incomplete: it lacks mipmap levels that its filter "
                    "needs (set GL_TEXTURE_MIN_FILTER or GL_TEXTURE_MAX_LEVEL), or a face");
        }
    }
}

}  // namespace stagelight
