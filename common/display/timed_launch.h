// SPDX-License-Identifier: MIT
// A frame on its way: when its rendering began and ended, and what it counted.
#pragma once

#include <future>
#include <vector>

#include "display/presenter.h"

namespace stagelight {

class TimedLaunch {
public:
    // Enqueues the rendering of one frame into `image`, with nothing waited for.
    TimedLaunch(const cl::CommandQueue &queue, StageKernel &kernel, const cl::Memory &image,
                const device::DoubleCamera &camera, int sample);

    // Waits for the end of the rendering.
    FinishedFrame finished();

private:
    std::size_t pixels_;
    int sample_;
    std::future<double> begin_;
    std::future<double> end_;
    std::vector<device::RayCounts> rows_;
    cl::Event rows_read_;
};

}  // namespace stagelight
