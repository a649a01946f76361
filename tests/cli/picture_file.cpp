// SPDX-License-Identifier: MIT
#include "cli/picture_file.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <OpenImageIO/imageio.h>

namespace stagelight::cli {

PictureFile read_picture_file(const std::filesystem::path &file) {
    const auto input = OIIO::ImageInput::open(file.string());
    if (!input) {
        OIIO::geterror();  // else it is printed at the end of the process
        return {};
    }
    const OIIO::ImageSpec &spec = input->spec();
    PictureFile picture{
        spec.width, spec.height, spec.nchannels, std::string(spec.format.c_str()), {}};
    picture.values.resize(spec.image_pixels() * static_cast<std::size_t>(spec.nchannels));
    input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, picture.values.data());
    return picture;
}

float largest_difference(const PictureFile &a, const PictureFile &b) {
    if (a.width != b.width || a.height != b.height || a.channels != b.channels) {
        return std::numeric_limits<float>::infinity();
    }
    float largest = 0;
    for (std::size_t i = 0; i < a.values.size(); ++i) {
        largest = std::max(largest, std::abs(a.values[i] - b.values[i]));
    }
    return largest;
}

}  // namespace stagelight::cli
