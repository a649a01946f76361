// SPDX-License-Identifier: MIT
// How precisely a device filters textures, which OpenCL leaves to it (specification 1.2, section
// 6.12.14): a tolerance goes by what a device does, not by its name.
#pragma once

#include "device/opencl.h"
#include "image/transfer.h"

namespace stagelight::golden {

// The largest error of kernels/texture.cl between a black texel and a white one, in light. Texels
// are stored as `decode` has it.
double filter_error(const cl::Device &device, Transfer decode);

}  // namespace stagelight::golden
