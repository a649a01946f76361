// SPDX-License-Identifier: MIT
#include "display/presenter.h"

namespace stagelight {

void Presenter::drain() noexcept {
    // A queue that has failed has nothing in flight; who uses it next is told.
    clFinish(queue_());
}

}  // namespace stagelight
