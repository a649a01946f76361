// SPDX-License-Identifier: MIT
#include "scene/plain_bmp.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstdlib>

#include "scene/bytes.h"

namespace stagelight {

namespace {

constexpr std::size_t file_header = 14;
constexpr std::size_t info_header = 40;  // BITMAPINFOHEADER
constexpr std::size_t headers = file_header + info_header;
constexpr std::uint32_t os2_header = 64;  // of another layout

enum Compression : std::uint32_t {
    rgb = 0,
    rle8 = 1,
    rle4 = 2,
    bit_fields = 3,
    alpha_bit_fields = 6
};

struct Layout {
    std::uint32_t info_size, pixels, compression, bits;
    std::int64_t width, height;
};

Layout layout_of(std::string_view bytes) {
    return {.info_size = little_endian(bytes, 14, 4),
            .pixels = little_endian(bytes, 10, 4),
            .compression = little_endian(bytes, 30, 4),
            .bits = little_endian(bytes, 28, 2),
            .width = static_cast<std::int32_t>(little_endian(bytes, 18, 4)),
            .height =
                std::abs(std::int64_t{static_cast<std::int32_t>(little_endian(bytes, 22, 4))})};
}

// Rows start at multiples of four bytes.
std::size_t row_size(std::int64_t width, std::uint32_t bits) {
    return static_cast<std::size_t>((width * bits + 31) / 32 * 4);
}

// Blue, green, red and alpha.
using Masks = std::array<std::uint32_t, 4>;

// They follow the old header, and are part of the new ones. Where a picture of 32 bits has none,
// its fourth byte means nothing.
Masks masks_of(std::string_view bytes, const Layout &layout) {
    if (layout.compression == rgb) {
        return layout.bits == 16 ? Masks{0x1f, 0x3e0, 0x7c00, 0} : Masks{0xff, 0xff00, 0xff0000, 0};
    }
    const bool has_alpha = layout.info_size >= 56 || layout.compression == alpha_bit_fields;
    return {little_endian(bytes, 62, 4), little_endian(bytes, 58, 4), little_endian(bytes, 54, 4),
            has_alpha ? little_endian(bytes, 66, 4) : 0};
}

char channel(std::uint32_t pixel, std::uint32_t mask) {
    if (mask == 0) {
        return 0;
    }
    const int shift = std::countr_zero(mask);
    return static_cast<char>(std::uint64_t{(pixel & mask) >> shift} * 255 / (mask >> shift));
}

// The old headers, for pixels of so many bits that follow them after `palette` bytes.
std::string plain_headers(std::string_view bytes, std::uint32_t bits, std::uint32_t compression,
                          std::size_t palette) {
    std::string plain(bytes.substr(0, headers));
    plain.resize(headers);
    put_little_endian(plain, 10, 4, static_cast<std::uint32_t>(headers + palette));
    put_little_endian(plain, 14, 4, info_header);
    put_little_endian(plain, 28, 2, bits);
    put_little_endian(plain, 30, 4, compression);
    return plain;
}

// As many rows as the file has.
std::string without_masks(std::string_view bytes, const Layout &layout) {
    const Masks masks = masks_of(bytes, layout);
    const std::size_t channels = masks[3] == 0 ? 3 : 4;
    std::string plain = plain_headers(bytes, static_cast<std::uint32_t>(8 * channels), rgb, 0);
    put_little_endian(plain, 34, 4, 0);  // the size of the pixels
    put_little_endian(plain, 46, 4, 0);  // colours of a palette
    const std::size_t from_size = row_size(layout.width, layout.bits);
    const std::size_t to_size = row_size(layout.width, static_cast<std::uint32_t>(8 * channels));
    std::string_view left = bytes.substr(std::min<std::size_t>(layout.pixels, bytes.size()));
    for (std::int64_t row = 0; row < layout.height && left.size() >= from_size; ++row) {
        for (std::size_t x = 0; x < static_cast<std::size_t>(layout.width); ++x) {
            const std::uint32_t pixel = little_endian(left, x * layout.bits / 8, layout.bits / 8);
            for (std::size_t c = 0; c < channels; ++c) {
                plain += channel(pixel, masks[c]);
            }
        }
        plain.resize(headers + (static_cast<std::size_t>(row) + 1) * to_size);
        left.remove_prefix(from_size);
    }
    return plain;
}

std::string with_old_header(std::string_view bytes, const Layout &layout) {
    const std::uint32_t colors_used = little_endian(bytes, 46, 4);
    const std::uint32_t most_colors = layout.bits <= 8 ? 1U << layout.bits : 0;
    const std::uint32_t colors =
        colors_used == 0 ? most_colors : std::min(colors_used, most_colors);
    const auto part = [&](std::size_t start, std::size_t size) {
        return bytes.substr(std::min(start, bytes.size()), size);
    };
    const std::string_view palette = part(file_header + layout.info_size, std::size_t{4} * colors);
    std::string plain = plain_headers(bytes, layout.bits, layout.compression, palette.size());
    plain += palette;
    plain += part(layout.pixels, std::string::npos);
    return plain;
}

}  // namespace

std::optional<std::string> plain_bmp(std::string_view bytes) {
    const Layout layout = layout_of(bytes);
    if (!bytes.starts_with("BM") || bytes.size() < headers || layout.info_size < info_header
        || layout.info_size == os2_header || layout.width <= 0 || layout.height == 0) {
        return std::nullopt;
    }
    const bool has_masks =
        layout.compression == bit_fields || layout.compression == alpha_bit_fields;
    if ((layout.bits == 16 || layout.bits == 24 || layout.bits == 32)
        && (has_masks || (layout.compression == rgb && layout.bits != 24))) {
        return without_masks(bytes, layout);
    }
    if (layout.info_size > info_header && layout.compression <= rle4) {
        return with_old_header(bytes, layout);
    }
    return std::nullopt;
}

}  // namespace stagelight
