// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "device/opencl.h"
#include "device/stage_kernel.h"
#include "scene/scene.h"

namespace stagelight {

// A number that is another where a picture, or what it costs, may be: of what the scene holds, the
// device and its driver, the kernels and the settings.
std::uint64_t fingerprint(const cl::Device &device, const std::string &stage, const Scene &scene,
                          const RenderSettings &settings);

}  // namespace stagelight
