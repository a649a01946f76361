// SPDX-License-Identifier: MIT
// The OpenCL contexts that share with OpenGL through this layer.
#pragma once

#include <memory>
#include <vector>

#include <CL/cl.h>

#include "gl_context.h"
#include "records.h"

namespace stagelight {

struct SharingContext {
    cl_context handle = nullptr;
    std::vector<cl_context_properties> properties;  // as the program gave them, with the last 0
    std::unique_ptr<GlContext> gl;
};

// Never destroyed: programs release their objects as late as in destructors of their own globals.
inline auto &contexts = *new Records<cl_context, SharingContext>;

// Throws Refusal CL_INVALID_CONTEXT when the context does not share through the layer.
std::shared_ptr<SharingContext> sharing_context(cl_context context);

// Whether sharing with this context is a driver's affair.
bool belongs_to_driver(cl_context context);

}  // namespace stagelight
