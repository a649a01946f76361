// SPDX-License-Identifier: MIT
// The frame of every stage's program: from the command line to the picture.
#pragma once

#include <string>

namespace stagelight {

// `stage` is its folder's name, "04_refraction_beer". Returns the program's exit code.
int run_stage(const std::string &stage, int argc, const char *const *argv);

}  // namespace stagelight
