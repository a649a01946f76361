// SPDX-License-Identifier: MIT
#include "scene/texture_set.h"

#include <algorithm>
#include <fstream>

#include <fmt/format.h>

#include "scene/errors.h"
#include "scene/picture.h"

namespace stagelight {

namespace fs = std::filesystem;

int texture_once(std::vector<Texture> &textures, const fs::path &name,
                 const std::function<Texture()> &read) {
    const auto known = std::find_if(textures.begin(), textures.end(),
                                    [&](const Texture &texture) { return texture.file == name; });
    const auto index = static_cast<int>(known - textures.begin());
    if (known == textures.end()) {
        textures.push_back(read());
    }
    return index;
}

int load_texture(std::vector<Texture> &textures, const fs::path &file,
                 const SourceLocation &where) {
    std::error_code error;
    const fs::path canonical = fs::canonical(file, error);
    if (error || !fs::is_regular_file(canonical, error)) {
        throw UserError(
            fmt::format("{}: no file {}, expected a picture", to_string(where), file.string()));
    }
    return texture_once(textures, canonical, [&] {
        std::ifstream stream(canonical, std::ios::binary);
        if (!stream) {
            throw UserError(
                fmt::format("{}: {} can't be opened, expected a picture that may be read",
                            to_string(where), file.string()));
        }
        return read_picture(stream, canonical, where);
    });
}

}  // namespace stagelight
