// SPDX-License-Identifier: MIT
#include "bench/peers/workers.h"

#include <xmmintrin.h>

#include <pmmintrin.h>

namespace stagelight::bench {

Workers::Workers(int threads) : gate_(threads + 1) {
    for (int i = 0; i < threads; ++i) {
        threads_.emplace_back([this] { loop(); });
    }
}

Workers::~Workers() {
    work_ = nullptr;
    gate_.arrive_and_wait();
}

void Workers::run(int count, const std::function<void(int)> &work) {
    work_ = &work;
    count_ = count;
    next_ = 0;
    gate_.arrive_and_wait();
    gate_.arrive_and_wait();
}

void Workers::loop() {
    // As Embree's manual advises.
    _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
    _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
    for (;;) {
        gate_.arrive_and_wait();
        if (work_ == nullptr) {
            return;
        }
        for (int i; (i = next_++) < count_;) {
            (*work_)(i);
        }
        gate_.arrive_and_wait();
    }
}

}  // namespace stagelight::bench
