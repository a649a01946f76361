// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <glm/vec4.hpp>

namespace stagelight {

// srgb_encode, srgb_decode, power_encode and power_decode of each value, worked out by a compute
// shader with kernels/transfer_curves.h in it, on a display of its own. Throws std::runtime_error.
std::vector<glm::vec4> curves_in_glsl(const std::vector<float> &values);

}  // namespace stagelight
