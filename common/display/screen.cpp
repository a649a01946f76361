// SPDX-License-Identifier: MIT
#include "display/screen.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "device/kernel_source.h"
#include "display/gl.h"
#include "image/split.h"
#include "transfer_curves.h"

namespace stagelight {
namespace {

// One triangle whose middle is the whole screen: no buffer, and no seam as two would have.
const char *const vertex_shader = R"(#version 330 core
void main() {
    gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
}
)";

const char *const fragment_shader = R"(
uniform sampler2D picture;
uniform ivec2 size;    // of the framebuffer, pixels
uniform float levels;  // steps of one of its channels, above 0
uniform int transfer;  // enum class Transfer
uniform ivec2 line;    // SplitLine
uniform float line_value;
out vec4 color;

vec3 light_at(ivec2 pixel) {
    if (textureSize(picture, 0) == size) {
        return texelFetch(picture, pixel, 0).rgb;  // a filter would spread a NaN
    }
    return textureLod(picture, (vec2(pixel) + 0.5) / vec2(size), 0.0).rgb;
}

float encode(int curve, float light) {
    if (curve == 1) {
        return srgb_encode(light);
    }
    if (curve == 3) {
        return table_encode(light);
    }
    return curve == 2 ? power_encode(light) : within_screen(light);
}

// As for the PNG: of all floats from 0 to 1 none gets another step, of 255 or of 1023, when a driver
// fuses the product and the sum.
float rounded(float value) {
    return floor(value * levels + 0.5) / levels;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.x, size.y - 1 - int(gl_FragCoord.y));  // from the top left
    vec3 light = light_at(pixel);
    int curve = pixel.x < line.x ? transfer : 0;
    vec3 value = vec3(encode(curve, light.r), encode(curve, light.g), encode(curve, light.b));
    if (pixel.x >= line.x && pixel.x < line.y) {
        value = vec3(line_value);
    }
    color = vec4(rounded(value.r), rounded(value.g), rounded(value.b), 1.0);
}
)";

static_assert(int(Transfer::none) == 0 && int(Transfer::srgb) == 1 && int(Transfer::power) == 2
              && int(Transfer::table) == 3);

std::string srgb_table_in_glsl() {
    const auto &table = transfer::srgb_table;
    return fmt::format("#define HAS_SRGB_TABLE\nconst float srgb_table[{}] = float[]({:.9e});\n",
                       table.size(), fmt::join(table, ", "));
}

std::string whole_fragment_shader() {
    return "#version 330 core\n" + srgb_table_in_glsl()
           + embedded_sources.at("kernels/transfer_curves.h") + fragment_shader;
}

}  // namespace

Screen::Screen() : program_(vertex_shader, whole_fragment_shader()) {
    glGenVertexArrays(1, &no_vertices_);
    glGenSamplers(1, &linear_);
    glSamplerParameteri(linear_, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glSamplerParameteri(linear_, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glSamplerParameteri(linear_, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glSamplerParameteri(linear_, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

Screen::~Screen() {
    glDeleteSamplers(1, &linear_);
    glDeleteVertexArrays(1, &no_vertices_);
}

void Screen::draw(unsigned picture, const glm::ivec2 &size, int color_bits, Transfer transfer,
                  const std::optional<double> &split) const {
    const SplitLine line = split ? split_line(*split, size.x) : SplitLine{size.x, size.x};
    glUseProgram(program_.id());
    glUniform1i(program_.uniform("picture"), 0);
    glUniform2i(program_.uniform("size"), size.x, size.y);
    glUniform1f(program_.uniform("levels"), float((1 << color_bits) - 1));
    glUniform1i(program_.uniform("transfer"), int(transfer));
    glUniform2i(program_.uniform("line"), line.begin, line.end);
    glUniform1f(program_.uniform("line_value"), split_line_value);

    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, picture);
    glBindSampler(0, linear_);
    glBindVertexArray(no_vertices_);
    glViewport(0, 0, size.x, size.y);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindSampler(0, 0);
    glBindVertexArray(0);
}

}  // namespace stagelight
