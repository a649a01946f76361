// SPDX-License-Identifier: MIT
// The layer that gives every device cl_khr_gl_sharing, loaded in the test that includes this.
#pragma once

#include <cstdlib>

namespace stagelight {

// Before the first call into OpenCL, which reads it.
inline const bool layer_loaded = setenv("OPENCL_LAYERS", STAGELIGHT_LAYER, 1) == 0;

}  // namespace stagelight
