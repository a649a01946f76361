// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <memory>
#include <new>

#include <FreeImage.h>

#include "image/rescale.h"

namespace stagelight {
namespace {

using Bitmap = std::unique_ptr<FIBITMAP, decltype(&FreeImage_Unload)>;

Bitmap owned(FIBITMAP *bitmap) {
    if (bitmap == nullptr) {
        throw std::bad_alloc();
    }
    return {bitmap, &FreeImage_Unload};
}

glm::vec4 *row_of(const Bitmap &bitmap, int row) {
    return reinterpret_cast<glm::vec4 *>(FreeImage_GetScanLine(bitmap.get(), row));
}

}  // namespace

// Upside down both times: FreeImage's row 0 is at the bottom.
FloatPicture rescale(const FloatPicture &picture, int width, int height) {
    const Bitmap before = owned(FreeImage_AllocateT(FIT_RGBAF, picture.width, picture.height));
    for (int row = 0; row < picture.height; ++row) {
        std::copy_n(picture.pixels.begin() + std::ptrdiff_t{row} * picture.width, picture.width,
                    row_of(before, row));
    }
    const Bitmap after = owned(FreeImage_Rescale(before.get(), width, height, FILTER_BOX));
    FloatPicture result{.width = width, .height = height, .pixels = {}};
    for (int row = 0; row < height; ++row) {
        result.pixels.insert(result.pixels.end(), row_of(after, row), row_of(after, row) + width);
    }
    return result;
}

}  // namespace stagelight
