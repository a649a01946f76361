// SPDX-License-Identifier: MIT
// A hidden window with an OpenGL context, on a display without a screen.
#pragma once

#include <vector>

// epoxy comes before GLFW, which would bring another OpenGL header.
#include <epoxy/gl.h>

#include <GLFW/glfw3.h>

#include "device/opencl.h"

namespace stagelight {

class GlWindow {
public:
    enum class Binding { glx, egl };

    // Its context, OpenGL 4.5 core, is current afterwards. It shares objects with `shares_with`.
    explicit GlWindow(Binding binding, const GlWindow *shares_with = nullptr);
    static GlWindow of_opengl_es(Binding binding) { return {binding, nullptr, true}; }
    ~GlWindow();
    GlWindow(const GlWindow &) = delete;
    GlWindow &operator=(const GlWindow &) = delete;

    void make_current() const { glfwMakeContextCurrent(window_); }
    static void make_none_current() { glfwMakeContextCurrent(nullptr); }

    // Of CL_GL_CONTEXT_KHR and CL_GLX_DISPLAY_KHR or CL_EGL_DISPLAY_KHR.
    cl_context_properties context() const { return context_; }
    cl_context_properties display() const { return display_; }
    cl_context_properties display_property() const;
    // As clCreateContext takes them, ending with 0.
    std::vector<cl_context_properties> properties(const cl::Platform &platform) const;

private:
    GlWindow(Binding binding, const GlWindow *shares_with, bool opengl_es);

    Binding binding_;
    GLFWwindow *window_;
    cl_context_properties context_;
    cl_context_properties display_;
};

}  // namespace stagelight
