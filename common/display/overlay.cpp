// SPDX-License-Identifier: MIT
#include "display/overlay.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <stb/stb_easy_font.h>

#include "display/gl.h"

namespace stagelight {
namespace {

const char *const vertex_shader = R"(#version 330 core
uniform vec2 size;  // of the framebuffer, pixels
layout(location = 0) in vec2 position;  // pixels from the upper left corner
void main() {
    vec2 share = position / size;
    gl_Position = vec4(2.0 * share.x - 1.0, 1.0 - 2.0 * share.y, 0.0, 1.0);
}
)";

const char *const fragment_shader = R"(#version 330 core
uniform vec4 ink;
out vec4 color;
void main() {
    color = ink;
}
)";

// In units of the font's; all columns as wide as its widest letters, for a compiler's carets.
constexpr int column_width = 7;
constexpr int row_height = 12;
constexpr int margin = 6;
constexpr int tab_columns = 4;

using Lines = std::vector<std::string>;

// The font has ASCII only. Of a character of several bytes in UTF-8 the first becomes '?'.
std::string printable(const std::string &line) {
    std::string text;
    for (const char c : line) {
        const bool continues = (static_cast<unsigned char>(c) & 0xC0) == 0x80;
        if (c == '\t') {
            text.append(tab_columns - text.size() % tab_columns, ' ');
        } else if (c >= ' ' && c <= '~') {
            text += c;
        } else if (!continues) {
            text += '?';
        }
    }
    return text;
}

Lines printable(const Lines &lines) {
    Lines result;
    std::transform(lines.begin(), lines.end(), std::back_inserter(result),
                   [](const std::string &line) { return printable(line); });
    return result;
}

// Columns and rows of a text.
glm::ivec2 extent(const Lines &lines) {
    std::size_t columns = 0;
    for (const std::string &line : lines) {
        columns = std::max(columns, line.size());
    }
    return {int(columns), int(lines.size())};
}

// Columns and rows for which there is room, with two margins on each side: the panel's and its own.
glm::ivec2 room(const glm::ivec2 &size, int scale) {
    const glm::ivec2 inside = size / scale - 4 * margin;
    return {std::max(0, inside.x / column_width), std::max(0, inside.y / row_height)};
}

// Pixels for one unit of the font: two look right on a usual screen.
int scale_for(const glm::ivec2 &text, const glm::ivec2 &size, float content_scale) {
    const int smallest = std::max(1, int(std::lround(content_scale)));
    int scale = std::max(smallest, int(std::lround(2 * content_scale)));
    while (scale > smallest && (text.x > room(size, scale).x || text.y > room(size, scale).y)) {
        --scale;
    }
    return scale;
}

void cut(Lines &lines, const glm::ivec2 &most) {
    lines.resize(std::min(lines.size(), std::size_t(most.y)));
    for (std::string &line : lines) {
        line.resize(std::min(line.size(), std::size_t(most.x)));
    }
}

// Two triangles.
void append_rectangle(std::vector<glm::vec2> &corners, const glm::vec2 &low,
                      const glm::vec2 &high) {
    corners.insert(corners.end(), {low, {high.x, low.y}, high, low, high, {low.x, high.y}});
}

// In the middle of its column, whose upper left corner is `at`, in units of the font's.
void append_letter(std::vector<glm::vec2> &corners, char letter, const glm::ivec2 &at, int scale) {
    struct Corner {
        float x, y, z;
        std::array<unsigned char, 4> color;
    };
    std::array<std::array<Corner, 4>, 32> quads;
    std::array<char, 2> text = {letter, '\0'};
    const int left = at.x + std::max(0, column_width - stb_easy_font_width(text.data())) / 2;
    const int count = stb_easy_font_print(float(left), float(at.y), text.data(), nullptr,
                                          quads.data(), sizeof(quads));
    for (std::size_t i = 0; i < std::size_t(count); ++i) {
        const Corner &low = quads[i][0];
        const Corner &high = quads[i][2];
        append_rectangle(corners, float(scale) * glm::vec2(low.x, low.y),
                         float(scale) * glm::vec2(high.x, high.y));
    }
}

}  // namespace

Overlay::Overlay() : program_(vertex_shader, fragment_shader) {
    glGenVertexArrays(1, &vertex_array_);
    glGenBuffers(1, &vertices_);
    glBindVertexArray(vertex_array_);
    glBindBuffer(GL_ARRAY_BUFFER, vertices_);
    glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, sizeof(glm::vec2), nullptr);
    glEnableVertexAttribArray(0);
    glBindVertexArray(0);
}

Overlay::~Overlay() {
    glDeleteBuffers(1, &vertices_);
    glDeleteVertexArrays(1, &vertex_array_);
}

void Overlay::draw(const Lines &lines, const glm::ivec2 &size, float content_scale) const {
    Lines text = printable(lines);
    const int scale = scale_for(extent(text), size, content_scale);
    cut(text, room(size, scale));

    std::vector<glm::vec2> corners;
    const glm::ivec2 panel = extent(text) * glm::ivec2(column_width, row_height) + 2 * margin;
    append_rectangle(corners, glm::vec2(float(margin * scale)),
                     glm::vec2(scale * (margin + panel)));
    const int panel_corners = int(corners.size());
    for (int row = 0; row < int(text.size()); ++row) {
        for (int column = 0; column < int(text[std::size_t(row)].size()); ++column) {
            append_letter(corners, text[std::size_t(row)][std::size_t(column)],
                          2 * margin + glm::ivec2(column * column_width, row * row_height), scale);
        }
    }
    glUseProgram(program_.id());
    glUniform2f(program_.uniform("size"), float(size.x), float(size.y));
    glViewport(0, 0, size.x, size.y);
    glBindVertexArray(vertex_array_);
    glBindBuffer(GL_ARRAY_BUFFER, vertices_);
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(corners.size() * sizeof(glm::vec2)), corners.data(),
                 GL_STREAM_DRAW);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glUniform4f(program_.uniform("ink"), 0, 0, 0, 0.75F);
    glDrawArrays(GL_TRIANGLES, 0, panel_corners);
    glUniform4f(program_.uniform("ink"), 1, 1, 1, 1);
    glDrawArrays(GL_TRIANGLES, panel_corners, int(corners.size()) - panel_corners);
    glDisable(GL_BLEND);
    glBindVertexArray(0);
}

}  // namespace stagelight
