// SPDX-License-Identifier: MIT
#include "scene/texture_set.h"

#include <algorithm>
#include <fstream>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "scene/errors.h"
#include "scene/picture.h"
#include "scene/sandbox.h"
#include "scene/serialise.h"

namespace stagelight {

namespace fs = std::filesystem;

namespace {

// `file` is as the user names it.
Texture read_file(const fs::path &canonical, const fs::path &file, const SourceLocation &where) {
    const std::string what = fmt::format("{}: {}", to_string(where), file.string());
    std::error_code unimportant;  // opening it will tell
    const std::string bytes = run_sandboxed(what, fs::file_size(canonical, unimportant), [&] {
        std::ifstream stream(canonical, std::ios::binary);
        if (!stream) {
            throw UserError(
                fmt::format("{} can't be opened, expected a picture that may be read", what));
        }
        return serialise(read_picture(stream, canonical, where));
    });
    std::optional<Texture> texture = deserialise_texture(bytes);
    if (!texture) {
        throw UserError(what + ": can't be read: the reader went astray, expected another picture");
    }
    return std::move(*texture);
}

}  // namespace

int texture_once(std::vector<Texture> &textures, const fs::path &name,
                 const std::function<Texture()> &read, Wraps wraps) {
    const auto known = std::ranges::find_if(textures, [&](const Texture &texture) {
        return texture.file == name && texture.wrap_u == wraps.u && texture.wrap_v == wraps.v;
    });
    const auto index = static_cast<int>(known - textures.begin());
    if (known == textures.end()) {
        const auto same_file = std::ranges::find(textures, name, &Texture::file);
        Texture texture = same_file == textures.end() ? read() : *same_file;
        texture.wrap_u = wraps.u;
        texture.wrap_v = wraps.v;
        textures.push_back(std::move(texture));
    }
    return index;
}

int load_texture(std::vector<Texture> &textures, const fs::path &file, const SourceLocation &where,
                 Wraps wraps) {
    std::error_code error;
    const fs::path canonical = fs::canonical(file, error);
    if (error || !fs::is_regular_file(canonical, error)) {
        throw UserError(
            fmt::format("{}: no file {}, expected a picture", to_string(where), file.string()));
    }
    return texture_once(
        textures, canonical, [&] { return read_file(canonical, file, where); }, wraps);
}

}  // namespace stagelight
