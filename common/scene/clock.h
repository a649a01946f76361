// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>

namespace stagelight {

// The host's steady clock now, milliseconds.
inline double now_milliseconds() {
    return std::chrono::duration<double, std::milli>(
               std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

}  // namespace stagelight
