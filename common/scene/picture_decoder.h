// SPDX-License-Identifier: MIT
// The library that decodes pictures: FreeImage, or stb_image where CMake has found no FreeImage.
#pragma once

#include <cstdint>
#include <istream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace stagelight {

struct PictureSize {
    std::uint64_t width;
    std::uint64_t height;
};

// One picture. What is optional is none where the picture is damaged or cut short.
class PictureDecoder {
public:
    virtual ~PictureDecoder() = default;

    virtual bool knows_format() const = 0;
    // For the message where it does not.
    virtual const char *formats() const = 0;
    // The format's name where FreeImage would know it; else "".
    virtual std::string missing_format() const { return {}; }

    // By the header alone.
    virtual std::optional<PictureSize> size() = 0;
    // Red, green, blue and alpha, 8 bits each, the top row first; no more than the file has is
    // made of it, so its gamma is ignored. Empty where the pixels are not of 8 or 16 bits.
    virtual std::optional<std::vector<std::uint8_t>> texels() = 0;

    // What the library said; "" for nothing.
    virtual std::string complaint() const = 0;
};

// `stream` must outlive the decoder.
std::unique_ptr<PictureDecoder> picture_decoder(std::istream &stream);

}  // namespace stagelight
