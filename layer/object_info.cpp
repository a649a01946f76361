// SPDX-License-Identifier: MIT
// Which object of OpenGL a memory object stands for: OpenCL Extension Specification,
// cl_khr_gl_sharing, "Querying OpenGL object information from an OpenCL memory object".
#include <CL/cl_gl.h>

#include "driver.h"
#include "layer.h"
#include "objects.h"

namespace stagelight {
namespace {

// Also throws Refusal CL_INVALID_MEM_OBJECT, the driver's, for what is no memory object.
bool is_drivers(cl_mem handle) {
    return objects.find(handle) == nullptr && belongs_to_driver(context_of(handle));
}

cl_int CL_API_CALL get_object_info(cl_mem handle, cl_gl_object_type *type, cl_GLuint *name) {
    return answer([&] {
        if (is_drivers(handle)) {
            return require(driver->clGetGLObjectInfo(handle, type, name));
        }
        const auto tell_of = [&](const auto &gl) {
            if (type != nullptr) {
                *type = gl.object();
            }
            if (name != nullptr) {
                *name = gl.name();
            }
        };
        std::visit(tell_of, made_from_gl(handle)->gl);
    });
}

void give(const GlTexture &texture, cl_gl_texture_info name, const Query &query) {
    require(query.value != nullptr || query.size_ret != nullptr, CL_INVALID_VALUE,
            "clGetGLTextureInfo has nowhere to put its result");
    const GLint level = texture.level();
    switch (name) {
    case CL_GL_TEXTURE_TARGET:
        return query.give(&texture.target().target, sizeof(GLenum));
    case CL_GL_MIPMAP_LEVEL:
        return query.give(&level, sizeof(level));
    default:
        throw Refusal{CL_INVALID_VALUE, "clGetGLTextureInfo does not know what it is asked"};
    }
}

cl_int CL_API_CALL get_texture_info(cl_mem handle, cl_gl_texture_info name, std::size_t size,
                                    void *value, std::size_t *size_ret) {
    return answer([&] {
        if (is_drivers(handle)) {
            return require(driver->clGetGLTextureInfo(handle, name, size, value, size_ret));
        }
        const auto record = made_from_gl(handle);
        const auto *const texture = std::get_if<GlTexture>(&record->gl);
        require(texture != nullptr, CL_INVALID_GL_OBJECT, "the object is no texture of OpenGL");
        give(*texture, name, {size, value, size_ret});
    });
}

}  // namespace

void install_object_info(cl_icd_dispatch &table) {
    table.clGetGLObjectInfo = get_object_info;
    table.clGetGLTextureInfo = get_texture_info;
}

}  // namespace stagelight
