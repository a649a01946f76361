// SPDX-License-Identifier: MIT
#include "display/gl.h"
#include "display/open_window.h"
#include "display/overlay.h"
#include "display/screen.h"
#include "display/shown.h"
#include "scene/errors.h"

namespace stagelight {
namespace {

class OpenGLObjects : public OnDisplay {};

// Objects of OpenGL that the window's context has.
int live_objects() {
    int count = 0;
    for (GLuint name = 1; name < 100; ++name) {
        for (const auto is : {glIsProgram, glIsShader, glIsVertexArray, glIsBuffer, glIsSampler}) {
            count += is(name) ? 1 : 0;
        }
    }
    return count;
}

TEST_F(OpenGLObjects, AreGoneWithTheirOwners) {
    const PictureTexture texture(Image(16, 16));
    const int before = live_objects();
    {
        const Screen screen;
        const Overlay overlay;
        screen.draw(texture.id(), {16, 16}, 8, Transfer::srgb);
        overlay.draw({"text"}, {16, 16}, 1);
        EXPECT_EQ(live_objects(), before + 2 * (3 + 1) + 2);
        EXPECT_THROW(ShaderProgram("nonsense", "nonsense"), MachineError);
    }
    glUseProgram(0);
    EXPECT_EQ(live_objects(), before);
    window.forget_complaints();
}

TEST_F(OpenGLObjects, AShaderThatIsWrongComesWithTheDriversLog) {
    const std::string vertex = "#version 330 core\nout vec3 nonsense;\n"
                               "void main() { gl_Position = vec4(nonsense, 1.0); }\n";
    const std::string fragment = "#version 330 core\nout vec4 color;\n"
                                 "void main() { color = vec4(1.0); }\n";
    const std::string undeclared = "#version 330 core\nvoid main() { nonsense = 1; }\n";
    const std::string does_not_link = "#version 330 core\nin vec4 nonsense; out vec4 color;\n"
                                      "void main() { color = nonsense; }\n";
    EXPECT_NO_THROW(ShaderProgram(vertex, fragment));
    for (const auto &[one, other] : {std::pair(undeclared, fragment), std::pair(vertex, undeclared),
                                     std::pair(vertex, does_not_link)}) {
        try {
            const ShaderProgram program(one, other);
            FAIL() << "expected an error";
        } catch (const MachineError &error) {
            EXPECT_NE(std::string(error.what()).find("nonsense"), std::string::npos)
                << error.what();
        }
    }
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
    window.forget_complaints();  // Mesa's, of the same
}

}  // namespace
}  // namespace stagelight
