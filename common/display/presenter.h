// SPDX-License-Identifier: MIT
// A presenter of each display path: how a picture gets from OpenCL into the texture that the window
// shows.
#pragma once

#include <cstddef>

#include "device/stage_kernel.h"
#include "display/float_texture.h"
#include "scene/clock.h"

namespace stagelight {

// On the host's steady clock, milliseconds.
struct Interval {
    double begin = 0;
    double end = 0;
    double length() const { return end - begin; }
};

struct FinishedFrame {
    RayTotals rays;
    Interval render;
    int sample = 0;  // the last of those that the texture shows the mean of
};

// All of it on the thread whose OpenGL context is current.
class Presenter {
public:
    Presenter(const cl::Context &context, const cl::Device &device, TextureFormat format)
        : context_(context), queue_(context, device), format_(format) {}
    virtual ~Presenter() = default;
    Presenter(const Presenter &) = delete;
    Presenter &operator=(const Presenter &) = delete;

    // What the kernel has to be built for.
    virtual Picture picture() const = 0;
    // How many frames may be started before the first of them is finished.
    virtual std::size_t most_in_flight() const = 0;
    // Makes room for pictures of that size in pixels. No frame is in flight.
    virtual void resize(int width, int height) = 0;
    // Starts to render a frame, which adds that sample to those before it, and does not wait for
    // it.
    virtual void start(StageKernel &kernel, const device::DoubleCamera &camera, int sample) = 0;
    // Waits for the frame that was started first; then texture() holds it.
    virtual FinishedFrame finish() = 0;

    virtual const FloatTexture &texture() const = 0;
    // Of the picture, on the OpenCL device.
    virtual std::size_t bytes() const = 0;
    const cl::Context &context() const { return context_; }

protected:
    // Lets what is in flight end, while what it writes to is still there.
    void drain() noexcept;
    const cl::CommandQueue &queue() const { return queue_; }
    TextureFormat format() const { return format_; }

private:
    cl::Context context_;
    cl::CommandQueue queue_;
    TextureFormat format_;
};

}  // namespace stagelight
