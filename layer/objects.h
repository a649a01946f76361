// SPDX-License-Identifier: MIT
// The OpenCL memory objects that stand for objects of OpenGL.
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include <CL/cl.h>

#include "contexts.h"
#include "gl_buffer.h"
#include "gl_renderbuffer.h"
#include "gl_texture.h"
#include "records.h"

namespace stagelight {

struct SharedObject {
    cl_mem handle = nullptr;
    std::shared_ptr<SharingContext> context;
    std::variant<GlBuffer, GlTexture, GlRenderbuffer> gl;
    std::vector<std::byte> staging;  // what is on its way between OpenGL and OpenCL
    std::atomic<bool> acquired = false;

    std::string name() const;  // "GL texture 3"
};

// Objects made from a shared one (a part of a buffer, an image over it) stand here with its record,
// for they are its memory.
inline auto &objects = *new Records<cl_mem, SharedObject>;

// Keeps the record until the driver destroys the object: its commands may outlive the program's
// last reference. Throws Refusal, having released the object.
void remember(cl_mem handle, const std::shared_ptr<SharedObject> &record);

// The record of an object that was itself made from one of OpenGL, not from a part of it. Throws
// Refusal CL_INVALID_GL_OBJECT for others.
std::shared_ptr<SharedObject> made_from_gl(cl_mem handle);

}  // namespace stagelight
