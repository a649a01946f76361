// SPDX-License-Identifier: MIT
// The OpenGL context that an OpenCL context shares with.
#pragma once

#include <array>
#include <cstdint>
#include <mutex>

namespace stagelight {

class GlContext {
public:
    enum class Binding { glx, egl };

    // `display` and `handle` as in CL_GLX_DISPLAY_KHR or CL_EGL_DISPLAY_KHR, and CL_GL_CONTEXT_KHR.
    GlContext(Binding binding, void *display, void *handle)
        : binding_(binding), display_(display), handle_(handle) {}
    ~GlContext();
    GlContext(const GlContext &) = delete;
    GlContext &operator=(const GlContext &) = delete;

    // Whether they identify a context of OpenGL. It need not be current.
    bool is_valid() const;

    // Throws Refusal unless this context, or one that shares objects with it, is current on the
    // calling thread: only then can the layer copy. CL_INVALID_OPERATION when none is, and
    // CL_INVALID_GL_SHAREGROUP_REFERENCE_KHR when it is a stranger or older than OpenGL 3.2.
    void require_current();

    // Prepares for being recognised from other contexts, if this one is current. Throws Refusal
    // CL_INVALID_GL_SHAREGROUP_REFERENCE_KHR when it is older than OpenGL 3.2.
    void mark_if_current();

private:
    void *current() const;
    bool carries_mark() const;

    Binding binding_;
    void *display_;
    void *handle_;
    // OpenGL cannot tell whether two contexts share objects. A buffer made in the one, with
    // contents that no other has, can be seen in the other if they do.
    std::mutex mutex_;
    unsigned mark_ = 0;
    std::array<std::uint32_t, 4> mark_contents_{};
};

}  // namespace stagelight
