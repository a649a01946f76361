// SPDX-License-Identifier: MIT
// The one place where exceptions end: every program's main is run_main(…).
#pragma once

#include <functional>

namespace stagelight {

// Runs `body` and returns its exit code. An exception becomes its message on stderr and the
// exit code of its kind (scene/errors.h): 2 the user's mistake, 3 the machine's lack. A
// std::logic_error is a bug of ours, and is let through.
int run_main(const std::function<int()> &body);

}  // namespace stagelight
