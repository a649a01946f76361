// SPDX-License-Identifier: MIT
#include "display/shader.h"

#include <cassert>

#include <fmt/format.h>

#include "display/gl.h"
#include "scene/errors.h"

namespace stagelight {
namespace {

// `get` and `get_log` are OpenGL's functions for a shader or for a program.
template <typename Get, typename GetLog>
void require(GLuint object, GLenum what, Get get, GetLog get_log) {
    GLint done = 0;
    get(object, what, &done);
    if (!done) {
        GLint length = 0;
        get(object, GL_INFO_LOG_LENGTH, &length);
        std::string log(std::size_t(length), '\0');
        get_log(object, length, &length, log.data());
        log.resize(std::size_t(length));
        throw MachineError(fmt::format("this graphics driver refuses a shader; another version of "
                                       "it may not, and --display none works without\n{}",
                                       log));
    }
}

void attach(GLuint program, GLenum kind, const std::string &source) {
    const GLuint shader = glCreateShader(kind);
    glAttachShader(program, shader);
    glDeleteShader(shader);  // once the program is gone
    const char *text = source.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    require(shader, GL_COMPILE_STATUS, glGetShaderiv, glGetShaderInfoLog);
}

}  // namespace

ShaderProgram::ShaderProgram(const std::string &vertex, const std::string &fragment)
    : id_(glCreateProgram()) {
    try {
        attach(id_, GL_VERTEX_SHADER, vertex);
        attach(id_, GL_FRAGMENT_SHADER, fragment);
        glLinkProgram(id_);
        require(id_, GL_LINK_STATUS, glGetProgramiv, glGetProgramInfoLog);
    } catch (...) {
        glDeleteProgram(id_);
        throw;
    }
}

ShaderProgram::~ShaderProgram() {
    glDeleteProgram(id_);
}

int ShaderProgram::uniform(const char *name) const {
    const int location = glGetUniformLocation(id_, name);
    assert(location >= 0);
    return location;
}

}  // namespace stagelight
