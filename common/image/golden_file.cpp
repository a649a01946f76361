// SPDX-License-Identifier: MIT
#include "image/golden_file.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "image/whole_file.h"
#include "scene/errors.h"

namespace stagelight {
namespace {

using OIIO::TypeDesc;

const std::vector<std::string> golden_channels = {"R", "G", "B", "edge"};
constexpr float largest_half = 65504;

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

void write_golden(const Golden &golden, const std::filesystem::path &file) {
    assert(golden.edge.size() == golden.image.pixels.size());
    OIIO::ImageSpec spec(golden.image.width, golden.image.height, 4, TypeDesc::HALF);
    spec.channelnames = golden_channels;
    spec.attribute("compression", "zip");
    spec.attribute("DateTime", "");  // else there is today's, and no file is the same as another
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const auto output = OIIO::ImageOutput::create("openexr", &memory);
    if (!output) {
        throw UserError(fmt::format("{}: {}", file.string(), OIIO::geterror()));
    }
    if (!output->open("openexr", spec)
        || !output->write_image(TypeDesc::FLOAT, interleave(golden, file).data())
        || !output->close()) {
        throw UserError(fmt::format("{}: {}", file.string(), output->geterror()));
    }
    write_whole(bytes, file);
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
