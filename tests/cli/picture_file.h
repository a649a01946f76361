// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace stagelight::cli {

// A picture as its file has it.
struct PictureFile {
    int width = 0, height = 0, channels = 0;
    std::string format;  // of a channel, OpenImageIO's word: "uint8", "float"
    std::vector<float> values;

    float at(int x, int y, int channel) const {
        return values[static_cast<std::size_t>((y * width + x) * channels + channel)];
    }
};

// A picture of size 0 where there is none that can be read.
PictureFile read_picture_file(const std::filesystem::path &file);

// The largest difference between values of two pictures of one size; infinite for two sizes.
float largest_difference(const PictureFile &a, const PictureFile &b);

}  // namespace stagelight::cli
