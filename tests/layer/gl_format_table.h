// SPDX-License-Identifier: MIT
// The formats that the specification promises, written down apart from the layer.
#pragma once

#include <cstddef>
#include <vector>

#include <epoxy/gl.h>

#include "device/opencl.h"

namespace stagelight {

struct PromisedFormat {
    GLenum internal;
    GLenum order;
    GLenum type;
    cl::ImageFormat image;
    std::size_t pixel;  // bytes
};

// cl_khr_gl_sharing's table of formats: RGBA, RG and R of each type, and sRGB.
std::vector<PromisedFormat> promised_formats();

}  // namespace stagelight
