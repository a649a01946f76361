// SPDX-License-Identifier: MIT
#include "scene/tga_rle.h"

#include <array>

namespace stagelight {

namespace {

struct Header {
    bool is_rle;
    std::streamoff picture;  // where it starts
    long pixels;
    long bytes_a_pixel;
};

// Truevision TGA File Format Specification 2.0, "TGA file header", fields 1 to 5.
Header read_header(std::istream &stream) {
    std::array<char, 18> bytes{};
    stream.seekg(0).read(bytes.data(), bytes.size());
    const auto byte = [&](std::size_t i) { return long{static_cast<unsigned char>(bytes[i])}; };
    const auto word = [&](std::size_t i) { return byte(i) + 256 * byte(i + 1); };
    const long map_bytes = byte(1) == 0 ? 0 : word(5) * ((byte(7) + 7) / 8);
    return {.is_rle = byte(2) >= 9 && byte(2) <= 11,
            .picture = 18 + byte(0) + map_bytes,
            .pixels = word(12) * word(14),
            .bytes_a_pixel = (byte(16) + 7) / 8};
}

// "Run-length encoding", in the same: a packet's first byte counts its pixels, less one; with the
// top bit set, one pixel is repeated.
bool packets_fill(std::istream &stream, const Header &header) {
    stream.seekg(header.picture);
    for (long missing = header.pixels; missing > 0;) {
        const int packet = stream.get();
        const long count = (packet & 127) + 1;
        const long bytes = (packet & 128 ? 1 : count) * header.bytes_a_pixel;
        if (!stream.ignore(bytes) || stream.gcount() < bytes) {
            return false;
        }
        missing -= count;
    }
    return true;
}

}  // namespace

TgaRle tga_rle(std::istream &stream) {
    stream.clear();
    const Header header = read_header(stream);
    TgaRle rle = TgaRle::none;
    if (header.is_rle) {
        rle = packets_fill(stream, header) ? TgaRle::whole : TgaRle::cut_short;
    }
    stream.clear();
    return rle;
}

}  // namespace stagelight
