// SPDX-License-Identifier: MIT
// Memory objects are made from objects of OpenGL: OpenCL Extension Specification,
// cl_khr_gl_sharing, "Creating OpenCL Memory Objects from OpenGL Objects".
#include "objects.h"

#include <algorithm>

#include <CL/cl_gl.h>

#include "driver.h"
#include "layer.h"

namespace stagelight {
namespace {

void CL_CALLBACK forget(cl_mem object, void *) {
    objects.erase(object);
}

void require_flags(cl_mem_flags flags) {
    require(flags == 0 || flags == CL_MEM_READ_WRITE || flags == CL_MEM_READ_ONLY
                || flags == CL_MEM_WRITE_ONLY,
            CL_INVALID_VALUE,
            "an object of OpenGL is shared with CL_MEM_READ_ONLY, CL_MEM_WRITE_ONLY or "
            "CL_MEM_READ_WRITE alone");
}

void require_supported(cl_context context, cl_mem_flags flags, cl_mem_object_type type,
                       const cl_image_format &format) {
    cl_uint count = 0;
    require(driver->clGetSupportedImageFormats(context, flags, type, 0, nullptr, &count));
    std::vector<cl_image_format> all(count);
    require(driver->clGetSupportedImageFormats(context, flags, type, count, all.data(), nullptr));
    const auto is_it = [&](const cl_image_format &each) {
        return each.image_channel_order == format.image_channel_order
               && each.image_channel_data_type == format.image_channel_data_type;
    };
    require(std::ranges::any_of(all, is_it), CL_INVALID_IMAGE_FORMAT_DESCRIPTOR,
            "the device has no image format for the GL object's internal format");
}

cl_mem make_memory(cl_context context, cl_mem_flags flags, const GlBuffer &gl) {
    return made_by(driver->clCreateBuffer, context, flags, gl.bytes(), nullptr);
}

template <typename GlImage>
cl_mem make_memory(cl_context context, cl_mem_flags flags, const GlImage &gl) {
    const cl_image_format format = gl.format().cl;
    require_supported(context, flags == 0 ? CL_MEM_READ_WRITE : flags, gl.image(), format);
    const auto [width, height, depth] = gl.region();
    cl_image_desc desc{};
    desc.image_type = gl.image();
    desc.image_width = width;
    desc.image_height = height;
    desc.image_depth = depth;
    desc.image_array_size = gl.image() == CL_MEM_OBJECT_IMAGE1D_ARRAY ? height : depth;
    return made_by(driver->clCreateImage, context, flags, &format, &desc, nullptr);
}

// `describe` makes the GlBuffer, GlTexture or GlRenderbuffer, of the current OpenGL context.
template <typename Describe>
cl_mem share(cl_context context, cl_mem_flags flags, Describe describe) {
    const auto sharing = sharing_context(context);
    require_flags(flags);
    sharing->gl->require_current();
    const auto gl = describe();
    std::vector<std::byte> staging(gl.bytes());
    const cl_mem handle = make_memory(context, flags, gl);
    remember(handle, std::shared_ptr<SharedObject>(
                         new SharedObject{handle, sharing, gl, std::move(staging)}));
    return handle;
}

cl_mem CL_API_CALL create_from_buffer(cl_context context, cl_mem_flags flags, cl_GLuint name,
                                      cl_int *errcode_ret) {
    return answer_handle(errcode_ret, [&] {
        return belongs_to_driver(context)
                   ? made_by(driver->clCreateFromGLBuffer, context, flags, name)
                   : share(context, flags, [=] { return GlBuffer(name); });
    });
}

cl_mem CL_API_CALL create_from_renderbuffer(cl_context context, cl_mem_flags flags, cl_GLuint name,
                                            cl_int *errcode_ret) {
    return answer_handle(errcode_ret, [&] {
        return belongs_to_driver(context)
                   ? made_by(driver->clCreateFromGLRenderbuffer, context, flags, name)
                   : share(context, flags, [=] { return GlRenderbuffer(name); });
    });
}

// clCreateFromGLTexture; clCreateFromGLTexture2D and 3D of OpenCL 1.0, which it replaced, know
// fewer targets.
template <auto Function, cl_gl_object_type... Known>
cl_mem CL_API_CALL create_from_texture(cl_context context, cl_mem_flags flags, cl_GLenum target,
                                       cl_GLint level, cl_GLuint name, cl_int *errcode_ret) {
    return answer_handle(errcode_ret, [&] {
        return belongs_to_driver(context)
                   ? made_by(driver->*Function, context, flags, target, level, name)
                   : share(context, flags, [=] {
                         const cl_gl_object_type object = texture_target(target).object;
                         require(sizeof...(Known) == 0 || ((object == Known) || ...),
                                 CL_INVALID_VALUE,
                                 "this function does not share textures of that target");
                         return GlTexture(target, level, name);
                     });
    });
}

}  // namespace

std::string SharedObject::name() const {
    return std::visit(
        [](const auto &of) {
            return std::string("GL ") + of.kind + " " + std::to_string(of.name());
        },
        gl);
}

void remember(cl_mem handle, const std::shared_ptr<SharedObject> &record) {
    objects.add(handle, record);
    const cl_int code = driver->clSetMemObjectDestructorCallback(handle, forget, nullptr);
    if (code != CL_SUCCESS) {
        objects.erase(handle);
        driver->clReleaseMemObject(handle);
        throw Refusal{code, {}};
    }
}

std::shared_ptr<SharedObject> made_from_gl(cl_mem handle) {
    auto found = objects.find(handle);
    require(found != nullptr && found->handle == handle, CL_INVALID_GL_OBJECT,
            "the memory object was not made from an object of OpenGL");
    return found;
}

void install_objects(cl_icd_dispatch &table) {
    table.clCreateFromGLBuffer = create_from_buffer;
    table.clCreateFromGLRenderbuffer = create_from_renderbuffer;
    table.clCreateFromGLTexture = create_from_texture<&cl_icd_dispatch::clCreateFromGLTexture>;
    table.clCreateFromGLTexture2D =
        create_from_texture<&cl_icd_dispatch::clCreateFromGLTexture2D, CL_GL_OBJECT_TEXTURE2D>;
    table.clCreateFromGLTexture3D =
        create_from_texture<&cl_icd_dispatch::clCreateFromGLTexture3D, CL_GL_OBJECT_TEXTURE3D>;
}

}  // namespace stagelight
