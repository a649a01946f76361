// SPDX-License-Identifier: MIT
#include "display/open_window.h"

#include <fmt/format.h>

#include "display/gl.h"

namespace stagelight {
namespace {

void note(GLenum, GLenum, GLuint, GLenum severity, GLsizei length, const GLchar *text,
          const void *complaints) {
    if (severity == GL_DEBUG_SEVERITY_HIGH || severity == GL_DEBUG_SEVERITY_MEDIUM) {
        static_cast<std::vector<std::string> *>(const_cast<void *>(complaints))
            ->emplace_back(text, std::size_t(length));
    }
}

}  // namespace

OpenWindow::OpenWindow(const WindowSettings &settings, int depth)
    : xvfb_(depth), window_(settings) {
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(note, &complaints_);
}

std::vector<std::string> OpenWindow::complaints() {
    glFinish();
    for (GLenum error = glGetError(); error != GL_NO_ERROR; error = glGetError()) {
        complaints_.push_back(fmt::format("glGetError {:#x}", error));
    }
    return complaints_;
}

}  // namespace stagelight
