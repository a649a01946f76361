// SPDX-License-Identifier: MIT
// texels PICTURE...: prints for each a line, its size and texels in hexadecimal digits, or what is
// wrong with it.
#include <cstdlib>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "scene/errors.h"
#include "scene/texture_set.h"

namespace stagelight {
namespace {

void print(const char *file) {
    std::vector<Texture> textures;
    try {
        load_texture(textures, file, {file});
        const Texture &texture = textures.front();
        fmt::print("{} {} {:02x}\n", texture.width, texture.height, fmt::join(texture.texels, ""));
    } catch (const UserError &error) {
        fmt::print("error: {}\n", error.what());
    }
}

}  // namespace
}  // namespace stagelight

int main(int count, char **files) {
    for (int i = 1; i < count; ++i) {
        stagelight::print(files[i]);
    }
    return EXIT_SUCCESS;
}
