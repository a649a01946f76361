// SPDX-License-Identifier: MIT
// What the benches draw with, and hold what they drew to.
#pragma once

#include <string>

#include "device/stage_kernel.h"
#include "reference/reference.h"
#include "scene/scene.h"

namespace stagelight::bench {

// The highest stage.
const std::string &full_tracer();

// As `stage` draws the scene where nobody says otherwise.
RenderSettings settings_of(const std::string &stage, const Scene &scene,
                           const Methods &methods = {});

// The scene as `stage` is to draw it by the same settings, by the reference in double.
reference::Result reference_of(const std::string &stage, const Scene &scene,
                               const RenderSettings &settings);

}  // namespace stagelight::bench
