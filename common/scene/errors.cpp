// SPDX-License-Identifier: MIT
#include "scene/errors.h"

#include <algorithm>

#include "scene/scene.h"

namespace stagelight {

std::string one_line(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](unsigned char c) { return c < ' '; }, ' ');
    return text;
}

std::string to_string(const SourceLocation &where) {
    if (where.line == 0) {
        return where.file;
    }
    return where.file + ':' + std::to_string(where.line) + ':' + std::to_string(where.column);
}

}  // namespace stagelight
