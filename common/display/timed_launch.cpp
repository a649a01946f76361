// SPDX-License-Identifier: MIT
#include "display/timed_launch.h"

#include <memory>

namespace stagelight {
namespace {

// When all that was enqueued before has ended. By a callback, since the host may look up from
// other work long after; and on the host's clock, which a device's own timestamps are not on.
std::future<double> end_of_commands(const cl::CommandQueue &queue) {
    auto promise = std::make_unique<std::promise<double>>();
    std::future<double> end = promise->get_future();
    cl::Event marker;
    queue.enqueueMarkerWithWaitList(nullptr, &marker);
    marker.setCallback(
        CL_COMPLETE,
        [](cl_event, cl_int, void *kept) {
            const std::unique_ptr<std::promise<double>> owned(
                static_cast<std::promise<double> *>(kept));
            owned->set_value(now_milliseconds());
        },
        promise.get());
    static_cast<void>(promise.release());  // the callback's, which is always called
    return end;
}

}  // namespace

TimedLaunch::TimedLaunch(const cl::CommandQueue &queue, StageKernel &kernel,
                         const cl::Memory &image, const device::DoubleCamera &camera, int sample)
    : pixels_(static_cast<std::size_t>(camera.size.s[0])
              * static_cast<std::size_t>(camera.size.s[1])),
      sample_(sample) {
    kernel.clear_ray_counts(queue, camera.size.s[1]);
    begin_ = end_of_commands(queue);
    kernel.launch(queue, image, camera, sample);
    end_ = end_of_commands(queue);
    kernel.read_ray_counts(queue, rows_);
    queue.enqueueMarkerWithWaitList(nullptr, &rows_read_);
}

FinishedFrame TimedLaunch::finished() {
    rows_read_.wait();
    return {totals_of(rows_, pixels_), {begin_.get(), end_.get()}, sample_};
}

}  // namespace stagelight
