// SPDX-License-Identifier: MIT
#include "scene/picture.h"

#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "scene/errors.h"
#include "scene/exif.h"
#include "scene/picture_decoder.h"
#include "scene/plain_bmp.h"
#include "scene/plain_tga.h"
#include "scene/texture_set.h"

namespace stagelight {

namespace {

// What the decoders read as it is meant.
std::string plain(std::string bytes) {
    std::optional<std::string> bmp = plain_bmp(bytes);
    return bmp ? *std::move(bmp) : plain_tga(bytes).value_or(std::move(bytes));
}

// As Exif numbers them; 2 is from right to left.
int orientation_of(const std::string &bytes) {
    return is_mirrored_tga(bytes) ? 2 : exif_orientation(bytes);
}

void turn(Texture &texture, int orientation) {
    if (orientation == 1) {
        return;
    }
    const bool swaps = orientation >= 5;
    const bool flips_x = orientation == 2 || orientation == 3 || orientation >= 7;
    const bool flips_y =
        orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
    const int width = swaps ? texture.height : texture.width;
    const int height = swaps ? texture.width : texture.height;
    std::vector<std::uint8_t> turned;
    turned.reserve(texture.texels.size());
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const int from_x = swaps ? y : x;
            const int from_y = swaps ? x : y;
            const auto column =
                static_cast<std::size_t>(flips_x ? texture.width - 1 - from_x : from_x);
            const auto row =
                static_cast<std::size_t>(flips_y ? texture.height - 1 - from_y : from_y);
            const std::uint8_t *texel =
                texture.texels.data()
                + 4 * (row * static_cast<std::size_t>(texture.width) + column);
            turned.insert(turned.end(), texel, texel + 4);
        }
    }
    texture.texels = std::move(turned);
    texture.width = width;
    texture.height = height;
}

}  // namespace

void require_texture_size(std::uint64_t width, std::uint64_t height,
                          const std::filesystem::path &name, const SourceLocation &where) {
    constexpr std::uint64_t largest = largest_texture_size;
    if (width == 0 || height == 0 || width > largest || height > largest
        || width * height > largest_texture_area) {
        throw UserError(
            fmt::format("{}: the picture {} has {} x {} texels, expected 1 to {} each way "
                        "and {} at most",
                        to_string(where), name.string(), width, height, largest_texture_size,
                        largest_texture_area));
    }
}

Texture read_picture(std::istream &file, const std::filesystem::path &name,
                     const SourceLocation &where) {
    std::ostringstream read;
    read << file.rdbuf();  // short where the disk fails, which a stream's iterator throws for
    std::string bytes = std::move(read).str();
    const int orientation = orientation_of(bytes);
    std::istringstream stream(plain(std::move(bytes)));
    const std::unique_ptr<PictureDecoder> decoder = picture_decoder(stream);
    const auto refuse = [&](const std::string &what) {
        const std::string complaint = decoder->complaint();
        throw UserError(fmt::format("{}: {} {}{}", to_string(where), name.string(), what,
                                    complaint.empty() ? "" : " (" + complaint + ")"));
    };
    const auto whole = [&](auto part) {
        if (!part) {
            refuse("is no whole picture, expected one that is not cut short or damaged");
        }
        return *std::move(part);
    };
    if (const std::string missing = decoder->missing_format(); !missing.empty()) {
        refuse(fmt::format("can't be read: this build reads no {}: FreeImage is not on this "
                           "system; convert the picture to PNG",
                           missing));
    }
    if (!decoder->knows_format()) {
        refuse(fmt::format("is not a picture that can be read, expected a {} picture",
                           decoder->formats()));
    }
    const PictureSize size = whole(decoder->size());
    require_texture_size(size.width, size.height, name, where);
    std::vector<std::uint8_t> texels = whole(decoder->texels());
    if (texels.empty()) {
        refuse("can't be brought to 8 bits a channel, expected 8 or 16 bits");
    }
    Texture texture{.file = name,
                    .width = static_cast<int>(size.width),
                    .height = static_cast<int>(size.height),
                    .texels = std::move(texels),
                    .where = where};
    turn(texture, orientation);
    return texture;
}

}  // namespace stagelight
