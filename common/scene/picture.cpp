// SPDX-License-Identifier: MIT
#include "scene/picture.h"

#include <memory>
#include <string>

#include <fmt/format.h>

#include "scene/errors.h"
#include "scene/picture_decoder.h"
#include "scene/texture_set.h"

namespace stagelight {

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

Texture read_picture(std::istream &stream, const std::filesystem::path &name,
                     const SourceLocation &where) {
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
    return {.file = name,
            .width = static_cast<int>(size.width),
            .height = static_cast<int>(size.height),
            .texels = std::move(texels),
            .where = where};
}

}  // namespace stagelight
