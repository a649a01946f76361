// SPDX-License-Identifier: MIT
#include "image/image_io.h"

#include <algorithm>
#include <cassert>
#include <cctype>
#include <cmath>
#include <string>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "image/split.h"
#include "image/whole_file.h"
#include "scene/errors.h"

namespace stagelight {
namespace {

using Bytes = std::vector<unsigned char>;
using OIIO::TypeDesc;

static_assert(sizeof(glm::vec3) == 3 * sizeof(float), "a row of pixels is a row of floats");

const std::vector<std::string> golden_channels = {"R", "G", "B", "edge"};
constexpr float largest_half = 65504;

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

// In memory, because OpenImageIO 2.4 reports success when it writes a PNG to a full disk.
Bytes file_of(const char *format, const OIIO::ImageSpec &spec, TypeDesc type, const void *values) {
    Bytes bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const auto output = OIIO::ImageOutput::create(format, &memory);
    if (!output) {
        throw UserError(fmt::format("{}: {}", format, OIIO::geterror()));
    }
    if (!output->open(format, spec) || !output->write_image(type, values) || !output->close()) {
        throw UserError(fmt::format("{}: {}", format, output->geterror()));
    }
    return bytes;
}

OIIO::ImageSpec spec_of(const Image &image, int channels, TypeDesc type) {
    return {image.width, image.height, channels, type};
}

// The date would make two files of one picture differ; OpenImageIO writes one if there is none.
Bytes encode_exr(OIIO::ImageSpec spec, const void *floats) {
    spec.attribute("DateTime", "");
    return file_of("openexr", spec, TypeDesc::FLOAT, floats);
}

// How the file says what its values are (PNG, third edition, 11.3.2.2 and 11.3.2.5): the
// chunk sRGB, with the gAMA and cHRM that old readers know, or gAMA alone.
void name_curve(OIIO::ImageSpec &spec, Transfer curve) {
    if (curve == Transfer::srgb) {
        spec.attribute("oiio:ColorSpace", "sRGB");
    } else if (curve == Transfer::power) {
        spec.attribute("oiio:ColorSpace", "GammaCorrected");
        spec.attribute("oiio:Gamma", 2.2F);
    }
}

// The bytes are ours: OpenImageIO, which gets and writes 8 bits, converts nothing.
Bytes encode_png(const Image &image, Transfer curve, bool split) {
    const auto to_byte = [](Transfer transfer, float light) {
        return static_cast<unsigned char>(encode(transfer, light) * 255 + 0.5F);
    };
    const SplitLine line =
        split ? split_line(split_share, image.width) : SplitLine{image.width, image.width};
    Bytes bytes;
    bytes.reserve(3 * image.pixels.size());
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const auto column = static_cast<int>(i % static_cast<std::size_t>(image.width));
        const bool on_line = column >= line.begin && column < line.end;
        const glm::vec3 pixel = on_line ? glm::vec3(split_line_value) : image.pixels[i];
        const Transfer transfer = column < line.begin ? curve : Transfer::none;
        bytes.insert(bytes.end(), {to_byte(transfer, pixel.r), to_byte(transfer, pixel.g),
                                   to_byte(transfer, pixel.b)});
    }
    OIIO::ImageSpec spec = spec_of(image, 3, TypeDesc::UINT8);
    name_curve(spec, curve);
    return file_of("png", spec, TypeDesc::UINT8, bytes.data());
}

// R, G, B and edge of each pixel; what half precision cannot hold is refused, not made infinite.
std::vector<float> interleave(const Golden &golden, const std::filesystem::path &file) {
    std::vector<float> values;
    values.reserve(4 * golden.edge.size());
    for (std::size_t i = 0; i < golden.edge.size(); ++i) {
        const glm::vec3 &pixel = golden.image.pixels[i];
        for (const float value : {pixel.r, pixel.g, pixel.b}) {
            if (!(std::abs(value) <= largest_half)) {
                throw UserError(fmt::format(
                    "{}: pixel ({}, {}) is {}; expected at most {}, what half precision holds",
                    file.string(), i % std::size_t(golden.image.width),
                    i / std::size_t(golden.image.width), value, largest_half));
            }
        }
        values.insert(values.end(), {pixel.r, pixel.g, pixel.b, golden.edge[i] != 0 ? 1.0F : 0.0F});
    }
    return values;
}

Golden separate(const std::vector<float> &values, const OIIO::ImageSpec &spec) {
    Golden golden{Image(spec.width, spec.height), {}};
    golden.edge.resize(golden.image.pixels.size());
    for (std::size_t i = 0; i < golden.edge.size(); ++i) {
        const float *pixel = &values[4 * i];
        golden.image.pixels[i] = {pixel[0], pixel[1], pixel[2]};
        golden.edge[i] = pixel[3] != 0;
    }
    return golden;
}

}  // namespace

void require_writable(const std::filesystem::path &file) {
    require_picture_name(file);
    require_writable_place(file);
}

void write_image(const Image &image, const std::filesystem::path &file, Transfer encode,
                 bool split) {
    require_picture_name(file);
    write_whole(extension_of(file) == ".png"
                    ? encode_png(image, encode, split)
                    : encode_exr(spec_of(image, 3, TypeDesc::FLOAT), image.pixels.data()),
                file);
}

void write_golden(const Golden &golden, const std::filesystem::path &file) {
    assert(golden.edge.size() == golden.image.pixels.size());
    OIIO::ImageSpec spec = spec_of(golden.image, 4, TypeDesc::HALF);
    spec.channelnames = golden_channels;
    spec.attribute("compression", "zip");
    write_whole(encode_exr(spec, interleave(golden, file).data()), file);
}

Golden read_golden(const std::filesystem::path &file) {
    const auto input = OIIO::ImageInput::open(file.string());
    if (!input) {
        throw UserError(fmt::format("{}: {}", file.string(), OIIO::geterror()));
    }
    const OIIO::ImageSpec &spec = input->spec();
    if (spec.channelnames != golden_channels) {  // OpenImageIO has put R, G, B first
        throw UserError(fmt::format("{}: expected the channels {}, found {}", file.string(),
                                    fmt::join(golden_channels, ", "),
                                    fmt::join(spec.channelnames, ", ")));
    }
    std::vector<float> values(4 * spec.image_pixels());
    if (!input->read_image(0, 0, 0, 4, TypeDesc::FLOAT, values.data())) {
        throw UserError(fmt::format("{}: {}", file.string(), input->geterror()));
    }
    if (!std::all_of(values.begin(), values.end(), [](float v) { return std::isfinite(v); })) {
        throw UserError(
            fmt::format("{}: expected finite numbers, found a NaN or an infinity", file.string()));
    }
    return separate(values, spec);
}

}  // namespace stagelight
