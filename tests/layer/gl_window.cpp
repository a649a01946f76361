// SPDX-License-Identifier: MIT
#include "layer/gl_window.h"

#include <stdexcept>

#include <epoxy/egl.h>
#include <epoxy/glx.h>

#include "display/xvfb.h"

namespace stagelight {
namespace {

// One for the process, for GLFW keeps its connection.
void need_display() {
    static const Xvfb xvfb;
    static const bool ready = glfwInit() == GLFW_TRUE;
    if (!ready) {
        throw std::runtime_error("GLFW does not start under Xvfb");
    }
}

template <typename Handle> cl_context_properties as_property(Handle handle) {
    return reinterpret_cast<cl_context_properties>(handle);
}

}  // namespace

GlWindow::GlWindow(Binding binding, const GlWindow *shares_with)
    : GlWindow(binding, shares_with, false) {}

GlWindow::GlWindow(Binding binding, const GlWindow *shares_with, bool opengl_es)
    : binding_(binding) {
    need_display();
    const bool glx = binding == Binding::glx;
    glfwDefaultWindowHints();
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    if (opengl_es) {
        glfwWindowHint(GLFW_CLIENT_API, GLFW_OPENGL_ES_API);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    } else {
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    }
    glfwWindowHint(GLFW_CONTEXT_CREATION_API, glx ? GLFW_NATIVE_CONTEXT_API : GLFW_EGL_CONTEXT_API);
    window_ = glfwCreateWindow(64, 64, "test", nullptr,
                               shares_with == nullptr ? nullptr : shares_with->window_);
    if (window_ == nullptr) {
        throw std::runtime_error("no window with OpenGL under Xvfb");
    }
    make_current();
    context_ = glx ? as_property(glXGetCurrentContext()) : as_property(eglGetCurrentContext());
    display_ = glx ? as_property(glXGetCurrentDisplay()) : as_property(eglGetCurrentDisplay());
}

GlWindow::~GlWindow() {
    glfwDestroyWindow(window_);
}

cl_context_properties GlWindow::display_property() const {
    return binding_ == Binding::glx ? CL_GLX_DISPLAY_KHR : CL_EGL_DISPLAY_KHR;
}

std::vector<cl_context_properties> GlWindow::properties(const cl::Platform &platform) const {
    return {CL_GL_CONTEXT_KHR,
            context_,
            CL_CONTEXT_PLATFORM,
            as_property(platform()),
            display_property(),
            display_,
            0};
}

}  // namespace stagelight
