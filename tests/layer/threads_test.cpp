// SPDX-License-Identifier: MIT
// OpenGL contexts of other threads, and what acquire and release wait for.
#include <atomic>
#include <barrier>
#include <chrono>
#include <thread>

#include "layer/sharing.h"

namespace stagelight {
namespace {

using Binding = GlWindow::Binding;
using namespace std::chrono_literals;

using Threads = OnEach;
STAGELIGHT_ON_EACH(Threads);

TEST_P(Threads, NeedACurrentOpenGLContext) {
    const Sharing sharing(GetParam());
    const GLuint texture = make_texture(4, 4, {});
    const cl::Memory image = sharing.share(texture);
    std::thread([&] {
        EXPECT_EQ(sharing.make(texture), (Made{nullptr, CL_INVALID_OPERATION}));
        EXPECT_EQ(sharing.acquire(image), CL_INVALID_OPERATION);
        cl_int code = CL_SUCCESS;
        EXPECT_EQ(clCreateEventFromGLsyncKHR(sharing.context(), nullptr, &code), nullptr);
        EXPECT_EQ(code, CL_INVALID_OPERATION);
    }).join();
    EXPECT_EQ(sharing.acquire(image), CL_SUCCESS);
}

TEST_P(Threads, MayUseAContextThatSharesObjects) {
    for (const Binding binding : {Binding::glx, Binding::egl}) {
        const Sharing sharing(GetParam(), binding);
        const Bytes pixels = random_bytes(64, 1);
        const cl::Memory image = sharing.share(make_texture(4, 4, pixels));
        glFinish();
        const GlWindow other(binding, &sharing.window);
        EXPECT_EQ(sharing.acquire(image), CL_SUCCESS);
        EXPECT_EQ(sharing.read_image(image, 4, {4, 4, 1}), pixels);
        EXPECT_EQ(sharing.release(image), CL_SUCCESS);
        sharing.window.make_current();
    }
}

TEST_P(Threads, MayNotUseAStrangersContext) {
    for (const Binding binding : {Binding::glx, Binding::egl}) {
        const Sharing sharing(GetParam(), binding);
        const cl::Memory image = sharing.share(make_texture(4, 4, {}));
        const GlWindow stranger(binding);
        make_buffer(Bytes(16));
        const GLuint of_the_same_name = make_texture(4, 4, {});
        EXPECT_EQ(sharing.make(of_the_same_name),
                  (Made{nullptr, CL_INVALID_GL_SHAREGROUP_REFERENCE_KHR}));
        EXPECT_EQ(sharing.acquire(image), CL_INVALID_GL_SHAREGROUP_REFERENCE_KHR);
        sharing.window.make_current();
        EXPECT_EQ(sharing.acquire(image), CL_SUCCESS);
    }
}

bool has_buffers() {
    GLuint name = 1;
    while (name < 100 && glIsBuffer(name) == GL_FALSE) {
        ++name;
    }
    return name < 100;
}

// The layer's own buffer, by which it knows a share group, goes with the OpenCL context.
TEST_P(Threads, LeaveNoBufferInOpenGL) {
    const GlWindow window(Binding::glx);
    const cl::Device device = device_named(GetParam());
    const cl::Platform platform = platform_of(device);
    EXPECT_FALSE(has_buffers());
    {
        const cl::Context context(device, window.properties(platform).data());
        EXPECT_TRUE(has_buffers());
    }
    EXPECT_FALSE(has_buffers());
}

TEST_P(Threads, AcquireWaitsForItsEvents) {
    const Sharing sharing(GetParam());
    const Bytes drawn = random_bytes(64, 2);
    const GLuint texture = make_texture(4, 4, random_bytes(64, 1));
    const cl::Memory image = sharing.share(texture);
    glFinish();
    const GlWindow other(Binding::glx, &sharing.window);
    sharing.window.make_current();
    cl::UserEvent ready(sharing.context);
    std::thread painter([&] {
        other.make_current();
        std::this_thread::sleep_for(50ms);
        glTextureSubImage2D(texture, 0, 0, 0, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE, drawn.data());
        glFinish();
        ready.setStatus(CL_COMPLETE);
        GlWindow::make_none_current();
    });
    EXPECT_EQ(clEnqueueAcquireGLObjects(sharing.queue(), 1, &image(), 1, &ready(), nullptr),
              CL_SUCCESS);
    EXPECT_EQ(sharing.read_image(image, 4, {4, 4, 1}), drawn);
    painter.join();
}

// Enqueues a write that starts when `start` is set.
void enqueue_write(const Sharing &sharing, const cl::CommandQueue &queue, const cl::Memory &image,
                   const Bytes &pixels, const cl::Event &start, cl_event *done) {
    const std::size_t origin[3] = {0, 0, 0};
    const std::size_t size[3] = {4, 4, 1};
    EXPECT_EQ(sharing.acquire(image), CL_SUCCESS);
    sharing.queue.finish();
    EXPECT_EQ(clEnqueueWriteImage(queue(), image(), CL_FALSE, origin, size, 0, 0, pixels.data(), 1,
                                  &start(), done),
              CL_SUCCESS);
}

TEST_P(Threads, ReleaseKeepsTheOrderOfTheQueue) {
    const Sharing sharing(GetParam());
    const Bytes written = random_bytes(64, 2);
    const GLuint texture = make_texture(4, 4, random_bytes(64, 1));
    const cl::Memory image = sharing.share(texture);
    cl::UserEvent start(sharing.context);
    enqueue_write(sharing, sharing.queue, image, written, start, nullptr);
    std::thread starter([&] {
        std::this_thread::sleep_for(50ms);
        start.setStatus(CL_COMPLETE);
    });
    EXPECT_EQ(sharing.release(image), CL_SUCCESS);
    EXPECT_EQ(texture_pixels(texture, 64), written);
    starter.join();
}

TEST_P(Threads, ReleaseWaitsForItsEvents) {
    const Sharing sharing(GetParam());
    const Bytes written = random_bytes(64, 2);
    const GLuint texture = make_texture(4, 4, random_bytes(64, 1));
    const cl::Memory image = sharing.share(texture);
    const cl::CommandQueue other(sharing.context, sharing.device);  // no order between the two
    cl::UserEvent start(sharing.context);
    cl::Event done;
    enqueue_write(sharing, other, image, written, start, &done());
    other.flush();
    std::thread starter([&] {
        std::this_thread::sleep_for(50ms);
        start.setStatus(CL_COMPLETE);
    });
    EXPECT_EQ(clEnqueueReleaseGLObjects(sharing.queue(), 1, &image(), 1, &done(), nullptr),
              CL_SUCCESS);
    EXPECT_EQ(texture_pixels(texture, 64), written);
    starter.join();
}

// Two threads try at the same moment, again and again: one of them gets it.
TEST_P(Threads, OneOfTwoAcquires) {
    const Sharing sharing(GetParam());
    const cl::Memory image = sharing.share(make_texture(1, 1, {}));
    const GlWindow one(Binding::glx, &sharing.window);
    const GlWindow other(Binding::glx, &sharing.window);
    GlWindow::make_none_current();
    std::barrier together(2);
    std::atomic<int> winners = 0;
    const auto compete = [&](const GlWindow &window) {
        window.make_current();
        for (int round = 1; round <= 2000; ++round) {
            together.arrive_and_wait();
            const bool won = sharing.acquire(image) == CL_SUCCESS;
            winners += won;
            together.arrive_and_wait();
            EXPECT_EQ(winners, round);
            EXPECT_TRUE(!won || sharing.release(image) == CL_SUCCESS);
        }
        GlWindow::make_none_current();
    };
    ::testing::internal::CaptureStderr();  // thousands of refusals
    std::thread first(compete, std::cref(one));
    std::thread second(compete, std::cref(other));
    first.join();
    second.join();
    ::testing::internal::GetCapturedStderr();
}

}  // namespace
}  // namespace stagelight
