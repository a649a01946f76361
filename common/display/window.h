// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include <glm/vec2.hpp>

#include "display/input.h"

struct GLFWwindow;

namespace stagelight {

// Where a window's OpenGL context comes from. native is GLX under X11, EGL under Wayland.
enum class ContextApi { native, egl };

struct WindowSettings {
    int width = 640;   // pixels
    int height = 384;  // pixels
    std::string title = "Stagelight";
    ContextApi api = ContextApi::native;
    bool vsync = true;  // off where frames are timed
};

// A window with an OpenGL core context of at least 3.3 that is current on the thread that made it
// for as long as it lives. One at a time, and on the main thread: GLFW wants that.
class Window {
public:
    // Throws MachineError: no display, or OpenGL is too old.
    explicit Window(const WindowSettings &settings);
    Window(const Window &) = delete;
    Window &operator=(const Window &) = delete;

    // The close button, Esc or close() has been pressed or called. The window stays until its
    // destructor.
    bool closed() const;
    void close();

    glm::ivec2 framebuffer_size() const;  // pixels; 0, 0 while the window is minimised
    float content_scale() const;          // pixels for one that a text of usual size counts
    int color_bits() const { return color_bits_; }  // a channel of the framebuffer: 8, or 10
    ContextApi api() const { return api_; }         // egl also where that is the native one

    void set_title(const std::string &title);
    void swap();

    // What has happened since the last call. wait returns at the first event, or after `seconds`,
    // which are finite.
    Input poll();
    Input wait(double seconds);

private:
    // GLFW itself, for the window's lifetime.
    struct Glfw {
        Glfw();
        ~Glfw();
        Glfw(const Glfw &) = delete;
        Glfw &operator=(const Glfw &) = delete;
    };
    struct Destroy {
        void operator()(GLFWwindow *window) const;
    };

    void listen();
    void pressed(int key);
    void drag(bool begins);
    void moved_to(const glm::dvec2 &position);
    Input take_input();

    Glfw glfw_;
    std::unique_ptr<GLFWwindow, Destroy> window_;
    ContextApi api_ = ContextApi::native;
    int color_bits_ = 0;
    Input input_;  // since the last call
    bool dragging_ = false;
    glm::dvec2 mouse_{0, 0};  // while it is dragged
};

}  // namespace stagelight
