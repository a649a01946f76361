// SPDX-License-Identifier: MIT
#include "display/shared_presenter.h"

#include <memory>

#include <fmt/format.h>

#include "device/device_choice.h"
#include "display/gl_sharing.h"

namespace stagelight {

SharedPresenter::SharedPresenter(const cl::Device &device, ContextApi api, TextureFormat format)
    : Presenter(shared_context(device, api), device, format) {
    if (has_extension(device, "cl_khr_gl_event")) {
        event_of_sync_ = reinterpret_cast<EventOfSync>(clGetExtensionFunctionAddressForPlatform(
            platform_of(device)(), "clCreateEventFromGLsyncKHR"));
    }
}

// #region share_texture
void SharedPresenter::resize(int width, int height) {
    image_.clear();
    texture_.emplace(format(), width, height);
    glFinish();  // the texture is there before OpenCL looks
    try {
        image_.push_back(
            cl::ImageGL(context(), CL_MEM_WRITE_ONLY, GL_TEXTURE_2D, 0, texture_->id()));
    } catch (const cl::Error &error) {
        throw PresenterLost(fmt::format("the texture can't be shared: {} failed with error {}",
                                        error.what(), error.err()));
    }
}
// #endregion share_texture

// #region texture_free
// What OpenCL must wait for before it may write: that OpenGL is done with the last frame. With
// cl_khr_gl_event the device waits, else this thread does.
std::vector<cl::Event> SharedPresenter::texture_free() {
    if (event_of_sync_ == nullptr) {
        glFinish();
        return {};
    }
    const std::unique_ptr<__GLsync, decltype(epoxy_glDeleteSync)> drawn(
        glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0), epoxy_glDeleteSync);
    glFlush();
    cl_int error = CL_SUCCESS;
    const cl_event event = event_of_sync_(context()(), drawn.get(), &error);
    if (error != CL_SUCCESS) {
        throw cl::Error(error, "clCreateEventFromGLsyncKHR");
    }
    return {cl::Event(event)};
}
// #endregion texture_free

// #region share
void SharedPresenter::start(StageKernel &kernel, const device::DoubleCamera &camera, int sample) {
    const std::vector<cl::Event> free = texture_free();
    queue().enqueueAcquireGLObjects(&image_, free.empty() ? nullptr : &free);
    launch_.emplace(queue(), kernel, image_.front(), camera, sample);
    queue().enqueueReleaseGLObjects(&image_, nullptr, &released_);
    queue().flush();
}

// The host waits, since it wants the counts; so OpenGL need not be told to.
FinishedFrame SharedPresenter::finish() {
    released_.wait();
    return launch_->finished();
}
// #endregion share

}  // namespace stagelight
