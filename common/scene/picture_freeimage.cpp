// SPDX-License-Identifier: MIT
#include "scene/picture_decoder.h"

#include <algorithm>
#include <array>

#include <FreeImage.h>

#include "scene/picture_stream.h"
#include "scene/tga_rle.h"

namespace stagelight {

namespace {

// FreeImage reads more, but its readers of KOALA and PCD take any text for a picture, those of
// PSD and PICT crash on a file that is cut short, GIF's and DDS's decode before the size can be
// checked, and TIFF's writes to the terminal.
constexpr std::array formats_read{FIF_BMP, FIF_JPEG, FIF_PBM,    FIF_PBMRAW, FIF_PGM, FIF_PGMRAW,
                                  FIF_PNG, FIF_PPM,  FIF_PPMRAW, FIF_TARGA,  FIF_WEBP};

using Bitmap = std::unique_ptr<FIBITMAP, decltype(&FreeImage_Unload)>;

Bitmap owned(FIBITMAP *bitmap) {
    return {bitmap, &FreeImage_Unload};
}

// FreeImage's handler of messages takes no user data.
std::string messages;

void keep_message(FREE_IMAGE_FORMAT, const char *message) {
    messages += messages.empty() ? message : std::string("; ") + message;
}

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

class FreeImageDecoder : public PictureDecoder {
public:
    explicit FreeImageDecoder(std::istream &stream) : stream_(stream) {
        messages.clear();
        FreeImage_SetOutputMessage(keep_message);
        format_ = FreeImage_GetFileTypeFromHandle(&io_, &stream_, 0);
    }

    bool knows_format() const override {
        return std::find(formats_read.begin(), formats_read.end(), format_) != formats_read.end();
    }

    const char *formats() const override { return "PNG, JPEG, BMP, TGA, WebP or PNM"; }

    std::optional<PictureSize> size() override {
        const Bitmap header = load_whole(FIF_LOAD_NOPIXELS);
        if (!header) {
            return std::nullopt;
        }
        return PictureSize{FreeImage_GetWidth(header.get()), FreeImage_GetHeight(header.get())};
    }

    std::optional<std::vector<std::uint8_t>> texels() override {
        const Bitmap bitmap = load_whole(0);
        if (!bitmap) {
            return std::nullopt;
        }
        const Bitmap converted = to_32_bits(bitmap);
        return converted ? texels_of(converted.get()) : std::vector<std::uint8_t>();
    }

    std::string complaint() const override { return messages; }

private:
    Bitmap load_whole(int flags) {
        stream_.rewind();
        // As the file has them: no decoding by the file's own gamma.
        const int exact = format_ == FIF_PNG    ? PNG_IGNOREGAMMA
                          : format_ == FIF_JPEG ? JPEG_ACCURATE
                                                : 0;
        Bitmap bitmap = owned(FreeImage_LoadFromHandle(format_, &io_, &stream_, flags | exact));
        return was_cut_short() ? owned(nullptr) : std::move(bitmap);
    }

    bool was_cut_short() const {
        // This reader and that of a TGA's runs read ahead by blocks, of which the last may be
        // short.
        if (format_ == FIF_JPEG) {
            return stream_.gave_nothing();
        }
        const TgaRle rle = format_ == FIF_TARGA ? tga_rle(stream_.stream()) : TgaRle::none;
        return rle == TgaRle::none ? stream_.gave_less() : rle == TgaRle::cut_short;
    }

    PictureStream stream_;
    FreeImageIO io_ = PictureStream::calls();
    FREE_IMAGE_FORMAT format_ = FIF_UNKNOWN;
};

}  // namespace

std::unique_ptr<PictureDecoder> picture_decoder(std::istream &stream) {
    return std::make_unique<FreeImageDecoder>(stream);
}

}  // namespace stagelight
