// SPDX-License-Identifier: MIT
// A stage's picture, for a file.
#pragma once

#include <string>

#include "app/run.h"

namespace stagelight {

// Draws the picture as often as --frames says. `reason` says why no window shows it.
RunResult draw(Run &run, const std::string &reason);

}  // namespace stagelight
