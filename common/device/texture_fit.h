// SPDX-License-Identifier: MIT
// Textures that are larger than a device's images.
#pragma once

#include <string>
#include <vector>

#include "device/opencl.h"
#include "device/texture_pages.h"
#include "image/transfer.h"
#include "scene/scene.h"

namespace stagelight {

// Rescales each texture that is wider or higher than fits, in the light that `decode` makes of it:
// a line of warning each.
std::vector<std::string> fit_textures(Scene &scene, const TextureLimits &limits, Transfer decode);

// The largest array of images that the device takes.
TextureLimits texture_limits(const cl::Device &device);

}  // namespace stagelight
