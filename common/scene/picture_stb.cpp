// SPDX-License-Identifier: MIT
#include "scene/picture_decoder.h"

#include <array>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string_view>

#include <stb/stb_image.h>

namespace stagelight {

namespace {

using namespace std::string_view_literals;

struct Signature {
    std::string_view bytes;
    std::string_view missing;  // the name of a format that stb_image does not read
};

// stb_image reads more, but so that both libraries read the same. A TGA has no signature.
constexpr std::array signatures{Signature{"\x89PNG\r\n\x1a\n"sv, ""},
                                Signature{"\xff\xd8\xff"sv, ""},
                                Signature{"BM"sv, ""},
                                Signature{"P5"sv, ""},
                                Signature{"P6"sv, ""},
                                Signature{"P1"sv, "PBM"},
                                Signature{"P2"sv, "PGM as text"},
                                Signature{"P3"sv, "PPM as text"},
                                Signature{"P4"sv, "PBM"}};

// The largest value of a PGM or PPM, whose header is three numbers, with comments between them
// (https://netpbm.sourceforge.net/doc/ppm.html).
// None where that is cut short or damaged.
std::optional<int> pnm_maximum(std::istream &stream) {
    stream.seekg(2);
    int value = 0;
    for (int i = 0; i < 3; ++i) {
        while ((stream >> std::ws).peek() == '#') {
            stream.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
        }
        stream >> value;
    }
    const bool is_whole = stream.good();
    stream.clear();
    return is_whole ? std::optional(value) : std::nullopt;
}

// stb_image takes what is missing for zeros, in most formats without a word. It reads ahead by
// blocks, always into the same place; the last one may be short, but only nothing is too little.
class CheckedReader {
public:
    explicit CheckedReader(std::istream &stream) : stream_(stream) { stream_.seekg(0); }

    bool was_cut_short() const { return was_cut_short_; }

    // To be given to stb_image with the address of a CheckedReader.
    static stbi_io_callbacks calls() {
        return {[](void *self, char *data, int size) {
                    return static_cast<CheckedReader *>(self)->read(data, size);
                },
                [](void *self, int count) { static_cast<CheckedReader *>(self)->skip(count); },
                [](void *self) { return static_cast<CheckedReader *>(self)->is_at_end() ? 1 : 0; }};
    }

private:
    int read(char *data, int size) {
        stream_.read(data, size);
        const auto got = static_cast<int>(stream_.gcount());
        stream_.clear();
        block_ = block_ ? block_ : data;
        was_cut_short_ = was_cut_short_ || got < (data == block_ ? 1 : size);
        return got;
    }

    // stb_image never skips back.
    void skip(int count) {
        stream_.ignore(count);
        was_cut_short_ = was_cut_short_ || stream_.gcount() < count;
        stream_.clear();
    }

    bool is_at_end() {
        const bool at_end = stream_.peek() == std::istream::traits_type::eof();
        stream_.clear();
        return at_end;
    }

    std::istream &stream_;
    const char *block_ = nullptr;
    bool was_cut_short_ = false;
};

class StbDecoder : public PictureDecoder {
public:
    explicit StbDecoder(std::istream &stream) : stream_(stream) {
        std::array<char, 12> start{};
        stream.seekg(0).read(start.data(), start.size());
        stream.clear();
        const std::string_view bytes(start.data(), start.size());
        for (const Signature &signature : signatures) {
            if (bytes.starts_with(signature.bytes)) {
                missing_format_ = signature.missing;
                knows_format_ = missing_format_.empty();
            }
        }
        if (bytes.starts_with("RIFF") && bytes.ends_with("WEBP")) {
            missing_format_ = "WebP";
        } else if (bytes[0] == 'P' && knows_format_ && pnm_maximum(stream).value_or(255) != 255) {
            missing_format_ = "PNM whose largest value is not 255";
        } else if (bytes[1] == 0 || bytes[1] == 1) {  // whether a TGA has a palette
            knows_format_ = info().has_value();
            complaint_.clear();
        }
    }

    bool knows_format() const override { return knows_format_; }
    const char *formats() const override { return "PNG, JPEG, BMP, TGA, PGM or PPM"; }
    std::string missing_format() const override { return missing_format_; }

    std::optional<PictureSize> size() override { return info(); }

    std::optional<std::vector<std::uint8_t>> texels() override {
        CheckedReader reader(stream_);
        const stbi_io_callbacks calls = CheckedReader::calls();
        int width = 0;
        int height = 0;
        const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> texels(
            stbi_load_from_callbacks(&calls, &reader, &width, &height, nullptr, STBI_rgb_alpha),
            stbi_image_free);
        if (!succeeds(texels != nullptr, reader)) {
            return std::nullopt;
        }
        return std::vector(texels.get(),
                           texels.get() + std::size_t{4} * unsigned(width) * unsigned(height));
    }

    std::string complaint() const override { return complaint_; }

private:
    std::optional<PictureSize> info() {
        CheckedReader reader(stream_);
        const stbi_io_callbacks calls = CheckedReader::calls();
        int width = 0;
        int height = 0;
        const bool is_read =
            stbi_info_from_callbacks(&calls, &reader, &width, &height, nullptr) != 0;
        if (!succeeds(is_read, reader)) {
            return std::nullopt;
        }
        // The height of a BMP whose top row is first is negative here.
        return PictureSize{unsigned(width), std::uint64_t(std::abs(std::int64_t{height}))};
    }

    bool succeeds(bool is_read, const CheckedReader &reader) {
        if (!is_read) {
            complaint_ = stbi_failure_reason();
        }
        return is_read && !reader.was_cut_short();
    }

    std::istream &stream_;
    bool knows_format_ = false;
    std::string missing_format_;
    std::string complaint_;
};

}  // namespace

std::unique_ptr<PictureDecoder> picture_decoder(std::istream &stream) {
    return std::make_unique<StbDecoder>(stream);
}

}  // namespace stagelight
