// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "display/gl.h"
#include "scene/errors.h"

namespace stagelight {

struct GlfwError {
    int code = GLFW_NO_ERROR;
    std::string text;  // one line
};

// What GLFW last complained of on this thread, which is then forgotten.
inline GlfwError take_glfw_error() {
    const char *text = nullptr;
    const int code = glfwGetError(&text);
    return {code, code == GLFW_NO_ERROR ? std::string() : one_line(text)};
}

}  // namespace stagelight
