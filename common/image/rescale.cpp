// SPDX-License-Identifier: MIT
// Along each axis in turn. FreeImage_Rescale, which the paper uses, is not on every system, and its
// box filter of 3.18 takes whole pixels: of 0, 3 and 6 it makes 1.5 and 6 in place of 1 and 5.
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "image/rescale.h"

namespace stagelight {
namespace {

// Of `from` pixels of a row, `stride` apart, their mean in each of `to` equal parts of it.
void rescale_row(const glm::vec4 *row, int from, glm::vec4 *out, int to, std::ptrdiff_t stride,
                 std::ptrdiff_t out_stride) {
    for (int i = 0; i < to; ++i) {
        const double begin = static_cast<double>(i) * from / to;
        const double end = static_cast<double>(i + 1) * from / to;
        glm::dvec4 sum(0);
        for (int j = static_cast<int>(begin); j < std::min(from, static_cast<int>(std::ceil(end)));
             ++j) {
            const double covered = std::min<double>(j + 1, end) - std::max<double>(j, begin);
            sum += covered * glm::dvec4(row[j * stride]);
        }
        out[i * out_stride] = glm::vec4(sum / (end - begin));
    }
}

std::size_t area(int width, int height) {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

}  // namespace

FloatPicture rescale(const FloatPicture &picture, int width, int height) {
    std::vector<glm::vec4> narrow(area(width, picture.height));
    for (std::ptrdiff_t row = 0; row < picture.height; ++row) {
        rescale_row(&picture.pixels[static_cast<std::size_t>(row * picture.width)], picture.width,
                    &narrow[static_cast<std::size_t>(row * width)], width, 1, 1);
    }
    FloatPicture result{width, height, std::vector<glm::vec4>(area(width, height))};
    for (int column = 0; column < width; ++column) {
        rescale_row(&narrow[static_cast<std::size_t>(column)], picture.height,
                    &result.pixels[static_cast<std::size_t>(column)], height, width, width);
    }
    return result;
}

}  // namespace stagelight
