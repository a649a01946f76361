// SPDX-License-Identifier: MIT
#include <stdexcept>

#include <png.h>

#include "image/encode_file.h"

namespace stagelight {
namespace {

using Bytes = std::vector<std::uint8_t>;

[[noreturn]] void refuse(png_structp, png_const_charp message) {
    throw std::logic_error(
        message);  // what is in memory, of a size that was checked, can be written
}

void ignore(png_structp, png_const_charp) {}

// libpng's two structures for one file.
struct Writer {
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, refuse, ignore);
    png_infop info = png_create_info_struct(png);

    explicit Writer(Bytes &out) {
        png_set_write_fn(
            png, &out,
            [](png_structp self, png_bytep data, std::size_t size) {
                Bytes &bytes = *static_cast<Bytes *>(png_get_io_ptr(self));
                bytes.insert(bytes.end(), data, data + size);
            },
            nullptr);
    }
    ~Writer() { png_destroy_write_struct(&png, &info); }
    Writer(const Writer &) = delete;
    Writer &operator=(const Writer &) = delete;
};

}  // namespace

std::vector<std::uint8_t> encode_png(const std::vector<std::uint8_t> &rgb, int width, int height,
                                     Transfer curve) {
    Bytes bytes;
    const Writer writer(bytes);
    png_set_IHDR(writer.png, writer.info, png_uint_32(width), png_uint_32(height), 8,
                 PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    // PNG, third edition, 11.3.2.2 and 11.3.2.5: the chunk sRGB, with the gAMA and cHRM that old
    // readers know, or gAMA alone.
    if (curve == Transfer::srgb || curve == Transfer::table) {
        png_set_sRGB_gAMA_and_cHRM(writer.png, writer.info, PNG_sRGB_INTENT_ABSOLUTE);
    } else if (curve == Transfer::power) {
        png_set_gAMA(writer.png, writer.info, 1 / 2.2);
    }
    png_write_info(writer.png, writer.info);
    for (int y = 0; y < height; ++y) {
        png_write_row(writer.png, &rgb[3 * std::size_t(y) * std::size_t(width)]);
    }
    png_write_end(writer.png, nullptr);
    return bytes;
}

}  // namespace stagelight
