// SPDX-License-Identifier: MIT
#include "display/rung.h"

namespace stagelight {

void Rung::drain() noexcept {
    // A queue that has failed has nothing in flight; who uses it next is told.
    clFinish(queue_());
}

}  // namespace stagelight
