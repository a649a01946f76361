// SPDX-License-Identifier: MIT
#include "display/shown.h"

#include <algorithm>
#include <cmath>

#include "cli/picture_file.h"
#include "display/gl.h"
#include "image/image_io.h"
#include "scene/temporary_folder.h"

namespace stagelight {
namespace {

int step_of(float value, int levels) {
    return int(std::lround(value * float(levels)));
}

}  // namespace

PictureTexture::PictureTexture(const Image &image) {
    glGenTextures(1, &id_);
    glBindTexture(GL_TEXTURE_2D, id_);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, image.width, image.height, 0, GL_RGB, GL_FLOAT,
                 image.pixels.data());
}

PictureTexture::~PictureTexture() {
    glDeleteTextures(1, &id_);
}

Steps framebuffer(const glm::ivec2 &framebuffer_size, const glm::ivec2 &corner, int color_bits) {
    std::vector<float> values(std::size_t(corner.x) * std::size_t(corner.y) * 3);
    glReadPixels(0, framebuffer_size.y - corner.y, corner.x, corner.y, GL_RGB, GL_FLOAT,
                 values.data());
    const int levels = (1 << color_bits) - 1;
    Steps steps{corner.x, {}};
    for (int y = corner.y - 1; y >= 0; --y) {
        for (int x = 0; x < corner.x; ++x) {
            const float *pixel = &values[3 * std::size_t(y * corner.x + x)];
            steps.pixels.push_back(
                {step_of(pixel[0], levels), step_of(pixel[1], levels), step_of(pixel[2], levels)});
        }
    }
    return steps;
}

Steps png(const Image &image, Transfer transfer) {
    const TemporaryFolder folder;
    write_image(image, folder.path() / "picture.png", transfer);
    const cli::PictureFile file = cli::read_picture_file(folder.path() / "picture.png");
    Steps steps{file.width, {}};
    for (std::size_t i = 0; i < file.values.size(); i += 3) {
        steps.pixels.push_back({step_of(file.values[i], 255), step_of(file.values[i + 1], 255),
                                step_of(file.values[i + 2], 255)});
    }
    return steps;
}

}  // namespace stagelight
