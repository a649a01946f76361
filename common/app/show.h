// SPDX-License-Identifier: MIT
// A stage's picture in a window.
#pragma once

#include <string>

#include "app/options.h"
#include "app/startup.h"
#include "device/stage_kernel.h"
#include "scene/scene.h"

namespace stagelight {

struct Shown {
    bool done = false;
    std::string reason;  // why not
};

// Shows the scene until the window is closed, on the display path of `options` or one after it.
// Where no window is to be had, throws MachineError if one was demanded, else says why.
Shown show(const std::string &stage, const Options &options, const Scene &scene,
           const RenderSettings &settings, Startup &startup);

}  // namespace stagelight
