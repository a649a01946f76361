// SPDX-License-Identifier: MIT
#include "kernels/curves_in_glsl.h"

#include <array>
#include <stdexcept>
#include <string>

#include <epoxy/gl.h>

#include <GLFW/glfw3.h>

#include "device/kernel_source.h"
#include "display/xvfb.h"

namespace stagelight {
namespace {

constexpr GLuint group = 64;

constexpr auto shader_head = "#version 430\n";
constexpr auto shader_main = R"(
layout(local_size_x = 64) in;
layout(std430, binding = 0) writeonly buffer Results { vec4 results[]; };
layout(std430, binding = 1) readonly buffer Values { float values[]; };
void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i < uint(values.length()))
        results[i] = vec4(srgb_encode(values[i]), srgb_decode(values[i]),
                          power_encode(values[i]), power_decode(values[i]));
}
)";

// OpenGL 4.3, for compute shaders, in a window that nobody sees.
class Context {
public:
    Context() {
        require(glfwInit() == GLFW_TRUE, "no GLFW");
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
        glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
        GLFWwindow *window = glfwCreateWindow(16, 16, "curves", nullptr, nullptr);
        require(window != nullptr, "no OpenGL 4.3");
        glfwMakeContextCurrent(window);
    }
    ~Context() { glfwTerminate(); }
    Context(const Context &) = delete;
    Context &operator=(const Context &) = delete;

    static void require(bool good, const std::string &what) {
        if (!good) {
            throw std::runtime_error(what);
        }
    }

private:
    Xvfb display_;
};

void use_program() {
    const std::string text =
        shader_head + embedded_sources.at("kernels/transfer_curves.h") + shader_main;
    const char *source = text.c_str();
    const GLuint program = glCreateShaderProgramv(GL_COMPUTE_SHADER, 1, &source);
    std::array<char, 4096> log{};
    glGetProgramInfoLog(program, GLsizei(log.size()), nullptr, log.data());
    Context::require(log[0] == '\0', log.data());  // warnings too
    glUseProgram(program);
}

void bind_buffer(GLuint binding, std::size_t bytes, const void *data) {
    GLuint buffer = 0;
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, buffer);
    glBufferData(GL_SHADER_STORAGE_BUFFER, GLsizeiptr(bytes), data, GL_STATIC_READ);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, buffer);
}

}  // namespace

std::vector<glm::vec4> curves_in_glsl(const std::vector<float> &values) {
    const Context context;
    std::vector<glm::vec4> results(values.size());
    use_program();
    bind_buffer(1, values.size() * sizeof values[0], values.data());
    bind_buffer(0, results.size() * sizeof results[0], nullptr);  // the last bound is read back
    glDispatchCompute(GLuint(values.size() / group + 1), 1, 1);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, GLsizeiptr(results.size() * sizeof results[0]),
                       results.data());
    Context::require(glGetError() == GL_NO_ERROR, "an OpenGL error");
    return results;
}

}  // namespace stagelight
