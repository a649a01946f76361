// SPDX-License-Identifier: MIT
#include "display/window.h"

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>

#include <epoxy/egl.h>
#include <fmt/format.h>

#include "display/glfw_error.h"

#define GLFW_EXPOSE_NATIVE_EGL
#include <GLFW/glfw3native.h>

namespace stagelight {
namespace {

constexpr int oldest_major = 3;
constexpr int oldest_minor = 3;

GLFWwindow *try_window(const WindowSettings &settings) {
    glfwWindowHint(GLFW_CONTEXT_CREATION_API, settings.api == ContextApi::egl
                                                  ? GLFW_EGL_CONTEXT_API
                                                  : GLFW_NATIVE_CONTEXT_API);
    return glfwCreateWindow(settings.width, settings.height, settings.title.c_str(), nullptr,
                            nullptr);
}

// The version of OpenGL that comes when none is asked for, which GLFW said is too old.
std::string version_found(const WindowSettings &settings) {
    glfwDefaultWindowHints();
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    GLFWwindow *window = try_window(settings);
    if (!window) {
        return "none";
    }
    glfwMakeContextCurrent(window);
    const GLubyte *text = glGetString(GL_VERSION);
    std::string version = text ? reinterpret_cast<const char *>(text) : "none";
    glfwDestroyWindow(window);
    return version;
}

[[noreturn]] void refuse(const WindowSettings &settings, const GlfwError &error) {
    if (error.code == GLFW_VERSION_UNAVAILABLE) {
        throw MachineError(fmt::format("a window needs OpenGL {}.{} or newer, found {}: expected a "
                                       "newer graphics driver, or --display none",
                                       oldest_major, oldest_minor, version_found(settings)));
    }
    throw MachineError(fmt::format("no OpenGL for a window ({}): expected a graphics driver that "
                                   "serves this display, or --display none",
                                   error.text));
}

GLFWwindow *open(const WindowSettings &settings) {
    glfwDefaultWindowHints();
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, oldest_major);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, oldest_minor);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    for (const int hint : {GLFW_RED_BITS, GLFW_GREEN_BITS, GLFW_BLUE_BITS}) {
        glfwWindowHint(hint, 10);  // what comes closest to it
    }
    for (const int hint : {GLFW_ALPHA_BITS, GLFW_DEPTH_BITS, GLFW_STENCIL_BITS}) {
        glfwWindowHint(hint, 0);
    }
    GLFWwindow *window = try_window(settings);
    if (!window) {
        refuse(settings, take_glfw_error());
    }
    return window;
}

// A channel of the window's, the smallest.
int framebuffer_bits() {
    constexpr std::array<GLenum, 3> channels = {GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE,
                                                GL_FRAMEBUFFER_ATTACHMENT_GREEN_SIZE,
                                                GL_FRAMEBUFFER_ATTACHMENT_BLUE_SIZE};
    int smallest = std::numeric_limits<int>::max();
    for (const GLenum channel : channels) {
        int bits = 0;
        glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, GL_BACK_LEFT, channel, &bits);
        smallest = std::min(smallest, bits);
    }
    return smallest;
}

}  // namespace

Window::Glfw::Glfw() {
    if (glfwGetCurrentContext()) {
        throw std::logic_error("a second window while the first is open");
    }
    glfwGetError(nullptr);  // that GLFW was not there to be asked is as it should be
    if (!glfwInit()) {
        throw MachineError(fmt::format("no display for a window ({}): expected a desktop "
                                       "session, Xvfb (xvfb-run PROGRAM), or --display none",
                                       take_glfw_error().text));
    }
}

Window::Glfw::~Glfw() {
    glfwTerminate();
}

void Window::Destroy::operator()(GLFWwindow *window) const {
    glfwDestroyWindow(window);
}

Window::Window(const WindowSettings &settings) : window_(open(settings)) {
    glfwMakeContextCurrent(window_.get());
    glfwSwapInterval(settings.vsync ? 1 : 0);
    if (const GlfwError error = take_glfw_error(); error.code != GLFW_NO_ERROR) {
        refuse(settings, error);
    }
    api_ =
        glfwGetEGLContext(window_.get()) == EGL_NO_CONTEXT ? ContextApi::native : ContextApi::egl;
    glfwGetError(nullptr);  // newer versions of GLFW call it an error that there is none
    color_bits_ = framebuffer_bits();
    listen();
}

bool Window::closed() const {
    return glfwWindowShouldClose(window_.get());
}

void Window::close() {
    glfwSetWindowShouldClose(window_.get(), GLFW_TRUE);
}

glm::ivec2 Window::framebuffer_size() const {
    glm::ivec2 size(0, 0);
    if (!glfwGetWindowAttrib(window_.get(), GLFW_ICONIFIED)) {
        glfwGetFramebufferSize(window_.get(), &size.x, &size.y);
    }
    return size;
}

float Window::content_scale() const {
    float x = 1;
    float y = 1;
    glfwGetWindowContentScale(window_.get(), &x, &y);
    return std::min(x, y);
}

void Window::set_title(const std::string &title) {
    glfwSetWindowTitle(window_.get(), title.c_str());
}

void Window::swap() {
    glfwSwapBuffers(window_.get());
}

}  // namespace stagelight
