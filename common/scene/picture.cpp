// SPDX-License-Identifier: MIT
#include "scene/picture.h"

#include <algorithm>
#include <array>
#include <memory>
#include <string>

#include <FreeImage.h>
#include <fmt/format.h>

#include "scene/errors.h"
#include "scene/picture_stream.h"
#include "scene/texture_set.h"
#include "scene/tga_runs.h"

namespace stagelight {

namespace {

// FreeImage reads more, but its readers of KOALA and PCD take any text for a picture, those of
// PSD and PICT crash on a file that is cut short, GIF's and DDS's decode before the size can be
// checked, and TIFF's writes to the terminal.
constexpr std::array formats_read{FIF_BMP, FIF_JPEG, FIF_PBM,    FIF_PBMRAW, FIF_PGM, FIF_PGMRAW,
                                  FIF_PNG, FIF_PPM,  FIF_PPMRAW, FIF_TARGA,  FIF_WEBP};
constexpr const char *formats_expected = "expected a PNG, JPEG, BMP, TGA, WebP or PNM picture";

using Bitmap = std::unique_ptr<FIBITMAP, decltype(&FreeImage_Unload)>;

Bitmap owned(FIBITMAP *bitmap) {
    return {bitmap, &FreeImage_Unload};
}

// FreeImage's handler of messages takes no user data.
std::string messages;

void keep_message(FREE_IMAGE_FORMAT, const char *message) {
    messages += messages.empty() ? message : std::string("; ") + message;
}

class Reader {
public:
    explicit Reader(std::istream &stream) : stream_(stream) {
        messages.clear();
        FreeImage_SetOutputMessage(keep_message);
        format_ = FreeImage_GetFileTypeFromHandle(&io_, &stream_, 0);
    }

    bool knows_format() const {
        return std::find(formats_read.begin(), formats_read.end(), format_) != formats_read.end();
    }

    Bitmap load(int flags) {
        stream_.rewind();
        // As the file has them: no decoding by the file's own gamma.
        const int exact = format_ == FIF_PNG    ? PNG_IGNOREGAMMA
                          : format_ == FIF_JPEG ? JPEG_ACCURATE
                                                : 0;
        return owned(FreeImage_LoadFromHandle(format_, &io_, &stream_, flags | exact));
    }

    bool was_cut_short() const {
        // This reader and that of a TGA's runs read ahead by blocks, of which the last may be
        // short.
        if (format_ == FIF_JPEG) {
            return stream_.gave_nothing();
        }
        const TgaRuns runs = format_ == FIF_TARGA ? tga_runs(stream_.stream()) : TgaRuns::none;
        return runs == TgaRuns::none ? stream_.gave_less() : runs == TgaRuns::cut_short;
    }

private:
    PictureStream stream_;
    FreeImageIO io_ = PictureStream::calls();
    FREE_IMAGE_FORMAT format_ = FIF_UNKNOWN;
};

// Null for pixels that are not of 8 or 16 bits.
Bitmap to_32_bits(const Bitmap &bitmap) {
    if (FreeImage_GetImageType(bitmap.get()) == FIT_UINT16) {
        return owned(
            FreeImage_ConvertTo32Bits(owned(FreeImage_ConvertTo8Bits(bitmap.get())).get()));
    }
    return owned(FreeImage_ConvertTo32Bits(bitmap.get()));
}

// FreeImage keeps the bottom row first, and the channels in an order of its own.
std::vector<std::uint8_t> texels_of(FIBITMAP *bitmap) {
    const unsigned width = FreeImage_GetWidth(bitmap);
    const unsigned height = FreeImage_GetHeight(bitmap);
    std::vector<std::uint8_t> texels;
    texels.reserve(std::size_t{4} * width * height);
    for (unsigned row = 0; row < height; ++row) {
        const BYTE *texel = FreeImage_GetScanLine(bitmap, static_cast<int>(height - 1 - row));
        for (const BYTE *end = texel + std::size_t{4} * width; texel != end; texel += 4) {
            texels.insert(texels.end(), {texel[FI_RGBA_RED], texel[FI_RGBA_GREEN],
                                         texel[FI_RGBA_BLUE], texel[FI_RGBA_ALPHA]});
        }
    }
    return texels;
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

Texture read_picture(std::istream &stream, const std::filesystem::path &name,
                     const SourceLocation &where) {
    const auto refuse = [&](const std::string &what) {
        throw UserError(fmt::format("{}: {} {}{}", to_string(where), name.string(), what,
                                    messages.empty() ? "" : " (" + messages + ")"));
    };
    Reader reader(stream);
    if (!reader.knows_format()) {
        refuse(std::string("is not a picture that can be read, ") + formats_expected);
    }
    const auto load_whole = [&](int flags) {
        Bitmap bitmap = reader.load(flags);
        if (!bitmap || reader.was_cut_short()) {
            refuse("is no whole picture, expected one that is not cut short or damaged");
        }
        return bitmap;
    };
    const Bitmap header = load_whole(FIF_LOAD_NOPIXELS);
    require_texture_size(FreeImage_GetWidth(header.get()), FreeImage_GetHeight(header.get()), name,
                         where);
    const Bitmap bitmap = load_whole(0);
    const Bitmap converted = to_32_bits(bitmap);
    if (!converted) {
        refuse("can't be brought to 8 bits a channel, expected 8 or 16 bits");
    }
    return {.file = name,
            .width = static_cast<int>(FreeImage_GetWidth(converted.get())),
            .height = static_cast<int>(FreeImage_GetHeight(converted.get())),
            .texels = texels_of(converted.get()),
            .where = where};
}

}  // namespace stagelight
