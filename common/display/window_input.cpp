// SPDX-License-Identifier: MIT
// What a window hears: GLFW calls back while it is polled.
#include <algorithm>
#include <array>
#include <utility>

#include "display/glfw_error.h"
#include "display/window.h"

namespace stagelight {
namespace {

constexpr std::array<std::pair<int, bool Input::*>, 6> held_keys = {{
    {GLFW_KEY_W, &Input::forward},
    {GLFW_KEY_S, &Input::back},
    {GLFW_KEY_A, &Input::left},
    {GLFW_KEY_D, &Input::right},
    {GLFW_KEY_SPACE, &Input::up},
    {GLFW_KEY_C, &Input::down},
}};
constexpr std::array<std::pair<int, bool Input::*>, 3> pressed_keys = {{
    {GLFW_KEY_R, &Input::reload},
    {GLFW_KEY_P, &Input::screenshot},
    {GLFW_KEY_F1, &Input::help},
}};

Window *owner(GLFWwindow *window) {
    return static_cast<Window *>(glfwGetWindowUserPointer(window));
}

}  // namespace

Input Window::poll() {
    glfwPollEvents();
    return take_input();
}

Input Window::wait(double seconds) {
    glfwWaitEventsTimeout(std::max(0.0, seconds));  // GLFW would abort
    return take_input();
}

Input Window::take_input() {
    for (const auto &[key, direction] : held_keys) {
        input_.*direction = glfwGetKey(window_.get(), key) == GLFW_PRESS;  // sticky: see listen
    }
    input_.trouble = take_glfw_error().text;
    return std::exchange(input_, {});
}

void Window::listen() {
    GLFWwindow *window = window_.get();
    glfwSetWindowUserPointer(window, this);
    glfwSetInputMode(window, GLFW_STICKY_KEYS, GLFW_TRUE);  // a tap between two calls counts
    glfwSetKeyCallback(window, [](GLFWwindow *w, int key, int, int action, int) {
        if (action == GLFW_PRESS) {
            owner(w)->pressed(key);
        }
    });
    glfwSetMouseButtonCallback(window, [](GLFWwindow *w, int button, int action, int) {
        if (button == GLFW_MOUSE_BUTTON_LEFT) {
            owner(w)->drag(action == GLFW_PRESS);
        }
    });
    glfwSetCursorPosCallback(window, [](GLFWwindow *w, double x, double y) {
        owner(w)->moved_to({x, y});
    });
    glfwSetScrollCallback(
        window, [](GLFWwindow *w, double, double notches) { owner(w)->input_.scroll += notches; });
    glfwSetFramebufferSizeCallback(
        window, [](GLFWwindow *w, int, int) { owner(w)->input_.resized = true; });
    glfwSetWindowIconifyCallback(window,
                                 [](GLFWwindow *w, int) { owner(w)->input_.resized = true; });
    glfwSetWindowRefreshCallback(window,
                                 [](GLFWwindow *w) { owner(w)->input_.needs_redraw = true; });
}

void Window::pressed(int key) {
    if (key == GLFW_KEY_ESCAPE) {
        close();
    }
    for (const auto &[known, event] : pressed_keys) {
        if (key == known) {
            input_.*event = true;
        }
    }
}

// The pointer is hidden and held meanwhile, so that the edge of the screen stops no drag.
void Window::drag(bool begins) {
    dragging_ = begins;
    glfwSetInputMode(window_.get(), GLFW_CURSOR,
                     begins ? GLFW_CURSOR_DISABLED : GLFW_CURSOR_NORMAL);
    glfwGetCursorPos(window_.get(), &mouse_.x, &mouse_.y);
}

void Window::moved_to(const glm::dvec2 &position) {
    if (dragging_) {
        input_.look += position - mouse_;
        mouse_ = position;
    }
}

}  // namespace stagelight
