// SPDX-License-Identifier: MIT
// OpenCL renders into memory of its own, and the picture is copied into the window's texture while
// the next frame is rendered.
#pragma once

#include <array>
#include <optional>

#include "display/presenter.h"
#include "display/timed_launch.h"

namespace stagelight {

// A pixel buffer of OpenGL's that stays mapped: OpenCL reads the picture into it, and OpenGL
// takes it from there (ARB_buffer_storage).
class PixelBuffer {
public:
    // Throws PresenterLost.
    explicit PixelBuffer(std::size_t bytes);
    ~PixelBuffer();
    PixelBuffer(const PixelBuffer &) = delete;
    PixelBuffer &operator=(const PixelBuffer &) = delete;

    // Where to write; waits until OpenGL has taken what was there.
    void *memory();
    // Hands what was written to the texture.
    void upload(const FloatTexture &texture);

private:
    GLuint id_ = 0;
    void *memory_ = nullptr;
    GLsync taken_ = nullptr;
};

class CopyPresenter : public Presenter {
public:
    // Throws PresenterLost where OpenGL can't keep a buffer mapped.
    CopyPresenter(const cl::Device &device, TextureFormat format);

    ~CopyPresenter() override { drain(); }

    Picture picture() const override { return Picture::buffer; }
    std::size_t most_in_flight() const override { return frames_.size(); }
    void resize(int width, int height) override;
    void start(StageKernel &kernel, const device::DoubleCamera &camera, int sample) override;
    FinishedFrame finish() override;
    const FloatTexture &texture() const override { return *texture_; }
    std::size_t bytes() const override { return image_.getInfo<CL_MEM_SIZE>(); }

private:
    struct Frame {
        std::optional<PixelBuffer> pixels;
        std::optional<TimedLaunch> launch;
        cl::Event copied;
    };

    cl::Device device_;
    std::optional<FloatTexture> texture_;
    cl::Buffer image_;
    std::array<Frame, 2> frames_;  // one is rendered while the other is shown
    std::size_t started_ = 0;
    std::size_t finished_ = 0;
};

}  // namespace stagelight
