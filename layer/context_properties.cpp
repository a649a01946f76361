// SPDX-License-Identifier: MIT
#include "context_properties.h"

#include <CL/cl_gl.h>

#include "refusal.h"

namespace stagelight {
namespace {

// Where a property of OpenGL's is kept, or null for one of another kind.
cl_context_properties *place_of(ContextProperties &properties, cl_context_properties name) {
    switch (name) {
    case CL_GL_CONTEXT_KHR:
        return &properties.gl_context;
    case CL_EGL_DISPLAY_KHR:
        return &properties.egl_display;
    case CL_GLX_DISPLAY_KHR:
        return &properties.glx_display;
    case CL_WGL_HDC_KHR:
        return &properties.wgl_device;
    case CL_CGL_SHAREGROUP_KHR:
        return &properties.cgl_group;
    default:
        return nullptr;
    }
}

void *pointer(cl_context_properties value) {
    void *result = nullptr;
    static_assert(sizeof(result) == sizeof(value));
    return reinterpret_cast<void *>(value);  // NOLINT(performance-no-int-to-ptr): OpenCL's own way
}

}  // namespace

ContextProperties::ContextProperties(const cl_context_properties *list) {
    for (; list != nullptr && *list != 0; list += 2) {
        all.insert(all.end(), {list[0], list[1]});
        cl_context_properties *const place = place_of(*this, list[0]);
        if (place != nullptr) {
            repeated = repeated || *place != 0;
            *place = list[1];
            continue;
        }
        others.insert(others.end(), {list[0], list[1]});
        user_sync = user_sync || list[0] == CL_CONTEXT_INTEROP_USER_SYNC;
        if (list[0] == CL_CONTEXT_PLATFORM) {
            platform = static_cast<cl_platform_id>(pointer(list[1]));
        }
    }
    if (list != nullptr) {
        all.push_back(0);
        others.push_back(0);
    }
}

// OpenCL Extension Specification, cl_khr_gl_sharing, "Additions to Chapter 4", the errors of
// clCreateContext.
std::unique_ptr<GlContext> named_gl_context(const ContextProperties &of) {
    const int displays =
        (of.egl_display != 0) + (of.glx_display != 0) + (of.wgl_device != 0) + (of.cgl_group != 0);
    require(displays <= 1, CL_INVALID_OPERATION,
            "more than one display or share group is among the context's properties");
    require(of.wgl_device == 0 && of.cgl_group == 0, CL_INVALID_OPERATION,
            "the layer shares with GLX and EGL, not with WGL or CGL");
    if (displays == 0 && of.gl_context == 0) {
        return nullptr;
    }
    require(!of.user_sync && !of.repeated, CL_INVALID_PROPERTY,
            "with OpenGL, CL_CONTEXT_INTEROP_USER_SYNC and repeated properties are refused");
    require(displays == 1 && of.gl_context != 0, CL_INVALID_GL_SHAREGROUP_REFERENCE_KHR,
            "the properties need CL_GL_CONTEXT_KHR and its display, both not null (was the OpenGL "
            "context current when the program asked for them?)");
    const bool glx = of.glx_display != 0;
    auto gl = std::make_unique<GlContext>(glx ? GlContext::Binding::glx : GlContext::Binding::egl,
                                          pointer(glx ? of.glx_display : of.egl_display),
                                          pointer(of.gl_context));
    require(gl->is_valid(), CL_INVALID_GL_SHAREGROUP_REFERENCE_KHR,
            "CL_GL_CONTEXT_KHR is no OpenGL context of its display");
    return gl;
}

}  // namespace stagelight
