// SPDX-License-Identifier: MIT
// The full tracer beside POV-Ray, on its own default scene.
#pragma once

#include "bench/report.h"
#include "device/opencl.h"

namespace stagelight::bench {

// Adds what it finds to `report`, and leaves the pictures and how far they are from the reference
// in out/peers; false where they are not the same.
bool race_povray(const cl::Device &device, int threads, ordered_json &report);

}  // namespace stagelight::bench
