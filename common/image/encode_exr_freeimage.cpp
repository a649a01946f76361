// SPDX-License-Identifier: MIT
#include <algorithm>
#include <memory>
#include <new>

#include <FreeImage.h>

#include "image/encode_file.h"

namespace stagelight {

static_assert(sizeof(glm::vec3) == sizeof(FIRGBF), "a row of pixels is a row of FreeImage's");

std::vector<std::uint8_t> encode_exr(const Image &image) {
    const std::unique_ptr<FIBITMAP, decltype(&FreeImage_Unload)> bitmap(
        FreeImage_AllocateT(FIT_RGBF, image.width, image.height), FreeImage_Unload);
    const std::unique_ptr<FIMEMORY, decltype(&FreeImage_CloseMemory)> file(
        FreeImage_OpenMemory(nullptr, 0), FreeImage_CloseMemory);
    if (!bitmap || !file) {
        throw std::bad_alloc();
    }
    for (int y = 0; y < image.height; ++y) {  // FreeImage's row 0 is the lowest
        std::copy_n(&image.at(0, y), image.width,
                    reinterpret_cast<glm::vec3 *>(
                        FreeImage_GetScanLine(bitmap.get(), image.height - 1 - y)));
    }
    BYTE *data = nullptr;
    DWORD size = 0;
    if (!FreeImage_SaveToMemory(FIF_EXR, bitmap.get(), file.get(), EXR_FLOAT | EXR_ZIP)
        || !FreeImage_AcquireMemory(file.get(), &data, &size)) {
        throw std::bad_alloc();
    }
    return {data, data + size};
}

}  // namespace stagelight
