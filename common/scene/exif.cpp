// SPDX-License-Identifier: MIT
#include "scene/exif.h"

#include <algorithm>
#include <cstddef>

#include "scene/bytes.h"

namespace stagelight {

namespace {

using namespace std::string_view_literals;

std::string_view part(std::string_view bytes, std::size_t start, std::size_t size) {
    return bytes.substr(std::min(start, bytes.size()), size);
}

// Of a JPEG's segments, each a marker of two bytes and its length, up to the first scan.
std::string_view exif_of_jpeg(std::string_view bytes) {
    constexpr std::uint32_t app1 = 0xffe1;
    constexpr std::uint32_t scan = 0xffda;
    for (std::size_t place = 2; place + 4 <= bytes.size();) {
        const std::uint32_t marker = big_endian(bytes, place, 2);
        const std::string_view segment = part(bytes, place + 4, big_endian(bytes, place + 2, 2));
        if (marker == app1 && segment.starts_with("Exif\0\0"sv)) {
            return segment.substr(6);
        }
        if (marker == scan || marker < 0xff00) {
            break;
        }
        place += 2 + std::max(2U, big_endian(bytes, place + 2, 2));
    }
    return {};
}

std::string_view exif_of_png(std::string_view bytes) {
    for (std::size_t place = 8; place + 8 <= bytes.size();) {
        const std::size_t length = big_endian(bytes, place, 4);
        if (part(bytes, place + 4, 4) == "eXIf") {
            return part(bytes, place + 8, length);
        }
        place += 12 + length;  // with the type and a check sum
    }
    return {};
}

// Of a RIFF file's chunks, each padded to an even length.
std::string_view exif_of_webp(std::string_view bytes) {
    for (std::size_t place = 12; place + 8 <= bytes.size();) {
        const std::size_t length = little_endian(bytes, place + 4, 4);
        if (part(bytes, place, 4) == "EXIF") {
            const std::string_view exif = part(bytes, place + 8, length);
            return exif.starts_with("Exif\0\0"sv) ? exif.substr(6) : exif;
        }
        place += 8 + length + length % 2;
    }
    return {};
}

std::string_view exif_of(std::string_view bytes) {
    if (bytes.starts_with("\xff\xd8"sv)) {
        return exif_of_jpeg(bytes);
    }
    if (bytes.starts_with("\x89PNG"sv)) {
        return exif_of_png(bytes);
    }
    return bytes.starts_with("RIFF") && part(bytes, 8, 4) == "WEBP" ? exif_of_webp(bytes)
                                                                    : std::string_view();
}

}  // namespace

int exif_orientation(std::string_view bytes) {
    constexpr std::uint32_t orientation_tag = 0x112;
    const std::string_view tiff = exif_of(bytes);
    const auto number = tiff.starts_with("MM") ? big_endian : little_endian;
    const std::size_t directory = number(tiff, 4, 4);
    const std::uint32_t entries = number(tiff, directory, 2);
    for (std::size_t i = 0; i < entries; ++i) {
        const std::size_t entry = directory + 2 + 12 * i;
        if (number(tiff, entry, 2) == orientation_tag) {
            const std::uint32_t orientation = number(tiff, entry + 8, 2);
            return orientation >= 1 && orientation <= 8 ? static_cast<int>(orientation) : 1;
        }
    }
    return 1;
}

}  // namespace stagelight
