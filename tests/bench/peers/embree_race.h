// SPDX-License-Identifier: MIT
// The full tracer beside Embree.
#pragma once

#include <string>

#include "bench/peers/workers.h"
#include "bench/report.h"
#include "device/opencl.h"

namespace stagelight::bench {

// On the scene tests/bench/peers/MODEL.toml. Adds what it finds to `report`; false where the
// pictures are not the same.
bool race_embree(const cl::Device &device, const std::string &model, Workers &workers,
                 ordered_json &report);

}  // namespace stagelight::bench
