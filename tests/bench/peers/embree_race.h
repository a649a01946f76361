// SPDX-License-Identifier: MIT
// The full tracer beside Embree.
#pragma once

#include <string>

#include "bench/peers/workers.h"
#include "bench/report.h"
#include "device/opencl.h"
#include "scene/scene.h"

namespace stagelight::bench {

// On a scene of one mesh and one point light. Adds what it finds to `report`, by the scene's name;
// false where the pictures are not the same.
bool race_embree(const cl::Device &device, const std::string &name, const Scene &scene,
                 Workers &workers, ordered_json &report);

}  // namespace stagelight::bench
