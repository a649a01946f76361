// SPDX-License-Identifier: MIT
#include "display/rung.h"

#include <chrono>

namespace stagelight {

double now_milliseconds() {
    return std::chrono::duration<double, std::milli>(
               std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

void Rung::drain() noexcept {
    // A queue that has failed has nothing in flight; who uses it next is told.
    clFinish(queue_());
}

}  // namespace stagelight
