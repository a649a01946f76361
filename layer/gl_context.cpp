// SPDX-License-Identifier: MIT
#include "gl_context.h"

#include <atomic>
#include <random>

#include <CL/cl_gl.h>
#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <epoxy/glx.h>

#include "gl_state.h"
#include "refusal.h"

namespace stagelight {
namespace {

std::atomic<bool> x_error_seen;

int note_x_error(Display *, XErrorEvent *) {
    x_error_seen = true;
    return 0;
}

// GLX answers a context that it does not know with an X error, which would end the program.
bool glx_knows(Display *display, GLXContext context) {
    static std::mutex one_at_a_time;  // the handler is the whole process's
    const std::scoped_lock lock(one_at_a_time);
    x_error_seen = false;
    const XErrorHandler before = XSetErrorHandler(note_x_error);
    glXIsDirect(display, context);
    XSync(display, False);
    XSetErrorHandler(before);
    return !x_error_seen;
}

bool egl_knows(EGLDisplay display, EGLContext context) {
    EGLint api = EGL_NONE;
    return eglQueryContext(display, context, EGL_CONTEXT_CLIENT_TYPE, &api) == EGL_TRUE
           && api == EGL_OPENGL_API;
}

void require_version() {
    require(epoxy_is_desktop_gl() && epoxy_gl_version() >= 32,
            CL_INVALID_GL_SHAREGROUP_REFERENCE_KHR,
            "the layer needs OpenGL 3.2 or later, and not OpenGL ES");
}

}  // namespace

// The program's context may be gone, and its name of the buffer another's: only what is surely the
// mark is deleted.
GlContext::~GlContext() {
    if (mark_ != 0 && current() == handle_ && carries_mark()) {
        glDeleteBuffers(1, &mark_);
    }
}

bool GlContext::is_valid() const {
    if (binding_ == Binding::egl) {
        return egl_knows(display_, handle_);
    }
    return current() == handle_
           || glx_knows(static_cast<Display *>(display_), static_cast<GLXContext>(handle_));
}

void *GlContext::current() const {
    return binding_ == Binding::glx ? static_cast<void *>(glXGetCurrentContext())
                                    : eglGetCurrentContext();
}

void GlContext::mark_if_current() {
    if (current() != handle_) {
        return;
    }
    require_version();
    const std::scoped_lock lock(mutex_);
    if (mark_ != 0) {
        return;
    }
    std::random_device random;
    for (std::uint32_t &each : mark_contents_) {
        each = random();
    }
    glGenBuffers(1, &mark_);
    const BoundBuffer bound(GL_COPY_WRITE_BUFFER, GL_COPY_WRITE_BUFFER_BINDING, mark_);
    glBufferData(GL_COPY_WRITE_BUFFER, sizeof(mark_contents_), mark_contents_.data(),
                 GL_STATIC_READ);
}

bool GlContext::carries_mark() const {
    if (glIsBuffer(mark_) == GL_FALSE) {
        return false;
    }
    const BoundBuffer bound(GL_COPY_READ_BUFFER, GL_COPY_READ_BUFFER_BINDING, mark_);
    GLint size = 0;
    glGetBufferParameteriv(GL_COPY_READ_BUFFER, GL_BUFFER_SIZE, &size);
    if (size != sizeof(mark_contents_)) {
        return false;
    }
    std::array<std::uint32_t, 4> contents{};
    glGetBufferSubData(GL_COPY_READ_BUFFER, 0, sizeof(contents), contents.data());
    return contents == mark_contents_;
}

void GlContext::require_current() {
    void *const now = current();
    require(now != nullptr, CL_INVALID_OPERATION,
            "no OpenGL context is current on the calling thread: a layer that copies needs it");
    require_version();
    mark_if_current();
    const std::scoped_lock lock(mutex_);
    require(now == handle_ || (mark_ != 0 && carries_mark()),
            CL_INVALID_GL_SHAREGROUP_REFERENCE_KHR,
            "the current OpenGL context shares no objects with that of the OpenCL context "
            "(or the latter was never current when the layer was called)");
}

}  // namespace stagelight
