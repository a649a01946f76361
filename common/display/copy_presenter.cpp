// SPDX-License-Identifier: MIT
#include "display/copy_presenter.h"

#include <limits>

#include "device/memory_need.h"

namespace stagelight {

// #region pixel_buffer
PixelBuffer::PixelBuffer(std::size_t bytes) {
    constexpr GLbitfield access = GL_MAP_WRITE_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
    const auto size = static_cast<GLsizeiptr>(bytes);
    glGenBuffers(1, &id_);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, id_);
    glBufferStorage(GL_PIXEL_UNPACK_BUFFER, size, nullptr, access);
    memory_ = glMapBufferRange(GL_PIXEL_UNPACK_BUFFER, 0, size, access);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    if (memory_ == nullptr) {
        glDeleteBuffers(1, &id_);
        throw PresenterLost("OpenGL has no memory for a mapped pixel buffer");
    }
}

PixelBuffer::~PixelBuffer() {
    glDeleteSync(taken_);
    glDeleteBuffers(1, &id_);  // which unmaps it
}

void *PixelBuffer::memory() {
    if (taken_ != nullptr) {
        glClientWaitSync(taken_, GL_SYNC_FLUSH_COMMANDS_BIT, std::numeric_limits<GLuint64>::max());
        glDeleteSync(taken_);
        taken_ = nullptr;
    }
    return memory_;
}

void PixelBuffer::upload(const FloatTexture &texture) {
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, id_);
    glBindTexture(GL_TEXTURE_2D, texture.id());
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, texture.width(), texture.height(), GL_RGBA, GL_FLOAT,
                    nullptr);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    taken_ = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
}
// #endregion pixel_buffer

CopyPresenter::CopyPresenter(const cl::Device &device, TextureFormat format)
    : Presenter(cl::Context(device), device, format), device_(device) {
    if (epoxy_gl_version() < 44 && !epoxy_has_gl_extension("GL_ARB_buffer_storage")) {
        throw PresenterLost("OpenGL has no ARB_buffer_storage, which 4.4 brings");
    }
}

void CopyPresenter::resize(int width, int height) {
    const std::size_t bytes = picture_bytes(device_, width, height);
    texture_.emplace(format(), width, height);
    image_ = cl::Buffer(context(), CL_MEM_WRITE_ONLY, bytes);
    for (Frame &frame : frames_) {
        frame.pixels.emplace(bytes);
    }
}

// #region copy
void CopyPresenter::start(StageKernel &kernel, const device::DoubleCamera &camera, int sample) {
    Frame &frame = frames_.at(started_++ % frames_.size());
    void *memory = frame.pixels->memory();
    frame.launch.emplace(queue(), kernel, image_, camera, sample);
    queue().enqueueReadBuffer(image_, CL_FALSE, 0, bytes(), memory, nullptr, &frame.copied);
    queue().flush();
}

FinishedFrame CopyPresenter::finish() {
    Frame &frame = frames_.at(finished_++ % frames_.size());
    frame.copied.wait();
    frame.pixels->upload(*texture_);
    return frame.launch->finished();
}
// #endregion copy

}  // namespace stagelight
