// SPDX-License-Identifier: MIT
#include "image/image_io.h"

#include <algorithm>
#include <cctype>
#include <string>

#include <fmt/format.h>

#include "image/encode_file.h"
#include "image/split.h"
#include "image/whole_file.h"
#include "scene/errors.h"
#include "scene/progress.h"

namespace stagelight {
namespace {

std::string extension_of(const std::filesystem::path &file) {
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return char(std::tolower(c)); });
    return extension;
}

void require_picture_name(const std::filesystem::path &file) {
    const std::string extension = extension_of(file);
    if (extension != ".png" && extension != ".exr") {
        throw UserError(
            fmt::format("{}: expected a name that ends in .png or .exr", file.string()));
    }
}

// The picture's values, three a pixel.
std::vector<std::uint8_t> bytes_of(const Image &image, Transfer curve, bool split) {
    // #region to_byte
    const auto to_byte = [](Transfer transfer, float light) {
        // NOLINTNEXTLINE(bugprone-incorrect-roundings): of 0 to 255 it is right, and lround is slow
        return static_cast<std::uint8_t>(encode(transfer, light) * 255 + 0.5F);
    };
    // #endregion to_byte
    const SplitLine line =
        split ? split_line(split_share, image.width) : SplitLine{image.width, image.width};
    std::vector<std::uint8_t> bytes;
    bytes.reserve(3 * image.pixels.size());
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const auto column = static_cast<int>(i % static_cast<std::size_t>(image.width));
        const bool on_line = column >= line.begin && column < line.end;
        const glm::vec3 pixel = on_line ? glm::vec3(split_line_value) : image.pixels[i];
        const Transfer transfer = column < line.begin ? curve : Transfer::none;
        bytes.insert(bytes.end(), {to_byte(transfer, pixel.r), to_byte(transfer, pixel.g),
                                   to_byte(transfer, pixel.b)});
    }
    return bytes;
}

}  // namespace

bool is_exr(const std::filesystem::path &file) {
    return extension_of(file) == ".exr";
}

void require_writable(const std::filesystem::path &file) {
    require_picture_name(file);
    require_writable_place(file);
}

void write_image(const Image &image, const std::filesystem::path &file, Transfer encode,
                 bool split) {
    require_picture_name(file);
    const Progress progress("writing " + file.filename().string());
    write_whole(is_exr(file)
                    ? encode_exr(image)
                    : encode_png(bytes_of(image, encode, split), image.width, image.height, encode),
                file);
}

}  // namespace stagelight
