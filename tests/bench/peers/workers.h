// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <barrier>
#include <functional>
#include <thread>
#include <vector>

namespace stagelight::bench {

// Threads that are started once and then share the work of each run: for every index below `count`
// one call.
class Workers {
public:
    explicit Workers(int threads);
    ~Workers();
    Workers(const Workers &) = delete;
    Workers &operator=(const Workers &) = delete;

    int size() const { return static_cast<int>(threads_.size()); }
    void run(int count, const std::function<void(int)> &work);

private:
    void loop();

    std::barrier<> gate_;  // passed by all at the start and at the end of a run
    const std::function<void(int)> *work_ = nullptr;  // none: it is over
    int count_ = 0;
    std::atomic<int> next_ = 0;
    std::vector<std::jthread> threads_;
};

}  // namespace stagelight::bench
