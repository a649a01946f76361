// SPDX-License-Identifier: MIT
#include "scene/plain_tga.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "scene/bytes.h"

namespace stagelight {

namespace {

constexpr std::size_t header_size = 18;
constexpr std::uint32_t mirrored = 0x10;  // of the descriptor

enum Type : std::uint32_t { mapped = 1, grey = 3 };  // and 8 more for runs

// Truevision TGA File Format Specification 2.0, "TGA file header", fields 1 to 5.
struct Layout {
    bool is_tga, has_runs;
    std::uint32_t type;
    std::size_t map, first, colors, color_bits;  // where the colour map is, and what it has
    std::size_t picture, pixels, bits;
};

Layout layout_of(std::string_view bytes) {
    const auto byte = [&](std::size_t place) { return byte_at(bytes, place); };
    const auto word = [&](std::size_t place) { return little_endian(bytes, place, 2); };
    const std::size_t map = header_size + byte(0);
    const std::size_t colors = byte(1) == 1 ? word(5) : 0;
    const std::uint32_t type = byte(2) & 7;
    return {.is_tga = bytes.size() > header_size && byte(1) <= 1 && type >= 1 && type <= 3
                      && (byte(2) & ~11U) == 0 && word(12) > 0 && word(14) > 0,
            .has_runs = (byte(2) & 8) != 0,
            .type = type,
            .map = map,
            .first = word(3),
            .colors = colors,
            .color_bits = byte(7),
            .picture = map + colors * ((byte(7) + 7) / 8),
            .pixels = std::size_t{word(12)} * word(14),
            .bits = byte(16)};
}

// Blue, green, red and alpha.
using Texel = std::array<char, 4>;

Texel color_of(std::string_view bytes, const Layout &layout, std::uint32_t index) {
    if (index < layout.first || index >= layout.first + layout.colors) {
        return {0, 0, 0, -1};
    }
    const std::size_t size = (layout.color_bits + 7) / 8;
    const std::size_t place = layout.map + (index - layout.first) * size;
    if (size == 2) {  // of five bits each
        const std::uint32_t color = little_endian(bytes, place, 2);
        const auto channel = [&](int shift) {
            return static_cast<char>((color >> shift & 31) * 255 / 31);
        };
        return {channel(0), channel(5), channel(10), -1};
    }
    const auto channel = [&](std::size_t i) {
        return static_cast<char>(byte_at(bytes, place + i));
    };
    return {channel(0), channel(1), channel(2), size == 4 ? channel(3) : char(-1)};
}

Texel texel_of(std::string_view bytes, const Layout &layout, std::size_t place) {
    if (layout.type == mapped) {
        return color_of(bytes, layout, little_endian(bytes, place, layout.bits / 8));
    }
    const auto value = static_cast<char>(byte_at(bytes, place));
    return {value, value, value, static_cast<char>(byte_at(bytes, place + 1))};
}

// Whether it is of those that a library reads wrong, and can be put right.
bool needs_texels(const Layout &layout) {
    if (layout.type == mapped) {
        const bool is_plain = layout.bits == 8 && layout.first == 0 && layout.color_bits >= 24;
        return !is_plain && (layout.bits == 8 || layout.bits == 16) && layout.color_bits > 8
               && layout.color_bits <= 32 && layout.colors > 0;
    }
    return layout.type == grey && layout.bits == 16;
}

}  // namespace

std::optional<std::string> plain_tga(std::string_view bytes) {
    const Layout layout = layout_of(bytes);
    const auto descriptor = static_cast<char>(byte_at(bytes, 17) & ~mirrored);
    if (is_mirrored_tga(bytes) && !needs_texels(layout)) {
        std::string plain(bytes);
        plain[17] = descriptor;
        return plain;
    }
    if (!layout.is_tga || !needs_texels(layout)) {
        return std::nullopt;
    }
    std::string plain(bytes.substr(0, header_size));
    std::fill_n(plain.begin(), 8, '\0');  // no name, no colour map
    plain[2] = layout.has_runs ? 10 : 2;
    plain[16] = 32;
    plain[17] = static_cast<char>((descriptor & ~15) | 8);  // bits of alpha
    const std::size_t size = layout.bits / 8;
    std::size_t place = layout.picture;
    const auto take_texel = [&] {
        const Texel texel = texel_of(bytes, layout, place);
        plain.append(texel.begin(), texel.end());
        place += size;
    };
    for (std::size_t pixels = 0; pixels < layout.pixels && place + size <= bytes.size();) {
        std::size_t count = layout.pixels;
        bool is_run = false;
        if (layout.has_runs) {
            const std::uint32_t packet = byte_at(bytes, place++);
            plain += static_cast<char>(packet);
            count = (packet & 127) + 1;
            is_run = (packet & 128) != 0;
        }
        for (std::size_t i = 0; i < (is_run ? 1 : count) && place + size <= bytes.size(); ++i) {
            take_texel();
        }
        pixels += count;
    }
    return plain;
}

bool is_mirrored_tga(std::string_view bytes) {
    return layout_of(bytes).is_tga && (byte_at(bytes, 17) & mirrored) != 0;
}

}  // namespace stagelight
