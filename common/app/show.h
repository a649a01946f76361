// SPDX-License-Identifier: MIT
// A stage's picture, in a window.
#pragma once

#include "app/run.h"

namespace stagelight {

// Shows the scene until the window is closed, on the first display path of the options that works.
// Throws PresenterLost where none does, and where no window is to be had, unless --window demands
// one: then MachineError.
RunResult show(Run &run);

}  // namespace stagelight
