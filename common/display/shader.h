// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace stagelight {

// A vertex and a fragment shader, linked, of the OpenGL context that is current on this thread and
// must be so in the destructor too.
class ShaderProgram {
public:
    // Throws MachineError with the driver's log when it takes one of the sources for wrong.
    ShaderProgram(const std::string &vertex, const std::string &fragment);
    ~ShaderProgram();
    ShaderProgram(const ShaderProgram &) = delete;
    ShaderProgram &operator=(const ShaderProgram &) = delete;

    unsigned id() const { return id_; }
    int uniform(const char *name) const;  // its location, of a name that the shaders use

private:
    unsigned id_;
};

}  // namespace stagelight
