// SPDX-License-Identifier: MIT
// The part of a context's properties that names an OpenGL context.
#pragma once

#include <memory>
#include <vector>

#include <CL/cl.h>

#include "gl_context.h"

namespace stagelight {

struct ContextProperties {
    std::vector<cl_context_properties> all;     // as given, with the last 0; empty for a null list
    std::vector<cl_context_properties> others;  // the same without those of OpenGL
    cl_platform_id platform = nullptr;
    bool user_sync = false;  // CL_CONTEXT_INTEROP_USER_SYNC is among them
    bool repeated = false;   // one of OpenGL's stands there twice
    cl_context_properties gl_context = 0;
    cl_context_properties egl_display = 0;
    cl_context_properties glx_display = 0;
    cl_context_properties wgl_device = 0;
    cl_context_properties cgl_group = 0;

    explicit ContextProperties(const cl_context_properties *list);
    bool name_gl() const { return others.size() != all.size(); }
};

// The OpenGL context they name, or null when they name none. Throws Refusal with the errors that
// cl_khr_gl_sharing adds to clCreateContext.
std::unique_ptr<GlContext> named_gl_context(const ContextProperties &properties);

}  // namespace stagelight
