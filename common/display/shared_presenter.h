// SPDX-License-Identifier: MIT
// OpenCL renders into the window's own texture: the paper's way (section 2), with no copy.
#pragma once

#include <optional>
#include <vector>

#include "display/presenter.h"
#include "display/timed_launch.h"
#include "display/window.h"

namespace stagelight {

class SharedPresenter : public Presenter {
public:
    // `api` is that of the current OpenGL context. Throws PresenterLost.
    SharedPresenter(const cl::Device &device, ContextApi api, TextureFormat format);

    ~SharedPresenter() override { drain(); }

    Picture picture() const override { return Picture::image; }
    std::size_t most_in_flight() const override { return 1; }  // there is one texture
    void resize(int width, int height) override;
    void start(StageKernel &kernel, const device::DoubleCamera &camera, int sample) override;
    FinishedFrame finish() override;
    const FloatTexture &texture() const override { return *texture_; }
    std::size_t bytes() const override { return texture_->bytes(); }

private:
    using EventOfSync = cl_event(CL_API_CALL *)(cl_context, cl_GLsync, cl_int *);

    std::vector<cl::Event> texture_free();

    EventOfSync event_of_sync_ = nullptr;  // null where the device has no cl_khr_gl_event
    std::optional<FloatTexture> texture_;
    std::vector<cl::Memory> image_;  // the texture, as OpenCL knows it
    std::optional<TimedLaunch> launch_;
    cl::Event released_;
};

}  // namespace stagelight
