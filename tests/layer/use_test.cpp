// SPDX-License-Identifier: MIT
// Commands are refused that use a shared object which is not acquired.
#include "layer/sharing.h"

namespace stagelight {
namespace {

using Use = OnEach;
STAGELIGHT_ON_EACH(Use);

constexpr std::size_t origin[3] = {0, 0, 0};
constexpr std::size_t size[3] = {4, 4, 1};
constexpr std::size_t rows[3] = {16, 4, 1};
constexpr std::size_t work[1] = {1};

// The codes of all commands that take an image, with `shared` in each place where one can be.
std::vector<cl_int> image_commands(const Sharing &on, cl_mem shared, cl_mem own,
                                   cl_mem own_buffer) {
    const cl_command_queue queue = on.queue();
    Bytes bytes(64);
    const float color[4] = {};
    std::vector<cl_int> codes{
        clEnqueueReadImage(queue, shared, CL_TRUE, origin, size, 0, 0, bytes.data(), 0, nullptr,
                           nullptr),
        clEnqueueWriteImage(queue, shared, CL_TRUE, origin, size, 0, 0, bytes.data(), 0, nullptr,
                            nullptr),
        clEnqueueCopyImage(queue, shared, own, origin, origin, size, 0, nullptr, nullptr),
        clEnqueueCopyImage(queue, own, shared, origin, origin, size, 0, nullptr, nullptr),
        clEnqueueCopyImageToBuffer(queue, shared, own_buffer, origin, size, 0, 0, nullptr, nullptr),
        clEnqueueCopyBufferToImage(queue, own_buffer, shared, 0, origin, size, 0, nullptr, nullptr),
        clEnqueueFillImage(queue, shared, color, origin, size, 0, nullptr, nullptr),
        clEnqueueMigrateMemObjects(queue, 1, &shared, 0, 0, nullptr, nullptr)};
    cl_int code = CL_SUCCESS;
    std::size_t pitch = 0;
    void *const mapped = clEnqueueMapImage(queue, shared, CL_TRUE, CL_MAP_READ, origin, size,
                                           &pitch, nullptr, 0, nullptr, nullptr, &code);
    codes.push_back(code);
    if (mapped != nullptr) {
        codes.push_back(clEnqueueUnmapMemObject(queue, shared, mapped, 0, nullptr, nullptr));
    }
    return codes;
}

std::vector<cl_int> buffer_commands(const Sharing &on, cl_mem shared, cl_mem own) {
    const cl_command_queue queue = on.queue();
    Bytes bytes(64);
    std::vector<cl_int> codes{
        clEnqueueReadBuffer(queue, shared, CL_TRUE, 0, 64, bytes.data(), 0, nullptr, nullptr),
        clEnqueueWriteBuffer(queue, shared, CL_TRUE, 0, 64, bytes.data(), 0, nullptr, nullptr),
        clEnqueueCopyBuffer(queue, shared, own, 0, 0, 64, 0, nullptr, nullptr),
        clEnqueueCopyBuffer(queue, own, shared, 0, 0, 64, 0, nullptr, nullptr),
        clEnqueueReadBufferRect(queue, shared, CL_TRUE, origin, origin, rows, 0, 0, 0, 0,
                                bytes.data(), 0, nullptr, nullptr),
        clEnqueueWriteBufferRect(queue, shared, CL_TRUE, origin, origin, rows, 0, 0, 0, 0,
                                 bytes.data(), 0, nullptr, nullptr),
        clEnqueueCopyBufferRect(queue, own, shared, origin, origin, rows, 0, 0, 0, 0, 0, nullptr,
                                nullptr),
        clEnqueueFillBuffer(queue, shared, bytes.data(), 4, 0, 64, 0, nullptr, nullptr)};
    cl_int code = CL_SUCCESS;
    void *const mapped =
        clEnqueueMapBuffer(queue, shared, CL_TRUE, CL_MAP_READ, 0, 64, 0, nullptr, nullptr, &code);
    codes.push_back(code);
    if (mapped != nullptr) {
        codes.push_back(clEnqueueUnmapMemObject(queue, shared, mapped, 0, nullptr, nullptr));
    }
    return codes;
}

void expect_all(const std::vector<cl_int> &codes, cl_int expected) {
    for (std::size_t i = 0; i < codes.size(); ++i) {
        EXPECT_EQ(codes[i], expected) << "command " << i;
    }
}

TEST_P(Use, OfAnImageNeedsAcquire) {
    const Sharing sharing(GetParam());
    const cl::Memory image = sharing.share(make_texture(4, 4, {}));
    const cl::Image2D own(sharing.context, CL_MEM_READ_WRITE, {CL_RGBA, CL_UNORM_INT8}, 4, 4);
    const cl::Buffer buffer(sharing.context, CL_MEM_READ_WRITE, 64);
    expect_all(image_commands(sharing, image(), own(), buffer()), CL_INVALID_GL_OBJECT);
    ASSERT_EQ(sharing.acquire(image), CL_SUCCESS);
    expect_all(image_commands(sharing, image(), own(), buffer()), CL_SUCCESS);
    ASSERT_EQ(sharing.release(image), CL_SUCCESS);
    expect_all(image_commands(sharing, image(), own(), buffer()), CL_INVALID_GL_OBJECT);
}

TEST_P(Use, OfABufferNeedsAcquire) {
    const Sharing sharing(GetParam());
    const cl::Memory shared = sharing.share_buffer(make_buffer(Bytes(64)));
    const cl::Buffer own(sharing.context, CL_MEM_READ_WRITE, 64);
    expect_all(buffer_commands(sharing, shared(), own()), CL_INVALID_GL_OBJECT);
    ASSERT_EQ(sharing.acquire(shared), CL_SUCCESS);
    expect_all(buffer_commands(sharing, shared(), own()), CL_SUCCESS);
    ASSERT_EQ(sharing.release(shared), CL_SUCCESS);
    expect_all(buffer_commands(sharing, shared(), own()), CL_INVALID_GL_OBJECT);
}

// Reading alone: PoCL 3.1 crashes when a rectangle is copied into a part of a buffer.
TEST_P(Use, OfAPartNeedsAcquireOfTheWhole) {
    const Sharing sharing(GetParam());
    const cl::Memory shared = sharing.share_buffer(make_buffer(Bytes(8192)));
    const cl_buffer_region region{4096, 4096};
    cl_int code = CL_SUCCESS;
    const cl::Memory part(clCreateSubBuffer(shared(), CL_MEM_READ_WRITE,
                                            CL_BUFFER_CREATE_TYPE_REGION, &region, &code),
                          false);
    ASSERT_EQ(code, CL_SUCCESS);
    const auto code_of_read = [&] {
        Bytes bytes(64);
        return clEnqueueReadBuffer(sharing.queue(), part(), CL_TRUE, 0, 64, bytes.data(), 0,
                                   nullptr, nullptr);
    };
    EXPECT_EQ(code_of_read(), CL_INVALID_GL_OBJECT);
    EXPECT_EQ(sharing.acquire(part), CL_INVALID_GL_OBJECT);  // it was not made from OpenGL
    EXPECT_EQ(clGetGLObjectInfo(part(), nullptr, nullptr), CL_INVALID_GL_OBJECT);
    ASSERT_EQ(sharing.acquire(shared), CL_SUCCESS);
    EXPECT_EQ(code_of_read(), CL_SUCCESS);
}

class Kernels : public OnEach {
protected:
    Sharing sharing{GetParam()};
    cl::Program program{sharing.context,
                        "kernel void fill(global uchar *to, uint by) { *to = (uchar)by; }"
                        "kernel void other(global uchar *to) { *to = 1; }"};
    cl::Kernel kernel;

    void SetUp() override {
        program.build();
        kernel = cl::Kernel(program, "fill");
        kernel.setArg(1, cl_uint{7});
    }
    cl_int run(const cl::Kernel &which) const {
        return clEnqueueNDRangeKernel(sharing.queue(), which(), 1, nullptr, work, nullptr, 0,
                                      nullptr, nullptr);
    }
};
STAGELIGHT_ON_EACH(Kernels);

TEST_P(Kernels, NeedAcquiredArguments) {
    const cl::Memory shared = sharing.share_buffer(make_buffer(Bytes(64)));
    const cl::Buffer own(sharing.context, CL_MEM_READ_WRITE, 64);
    kernel.setArg(0, shared);
    EXPECT_EQ(run(kernel), CL_INVALID_GL_OBJECT);
    EXPECT_EQ(clEnqueueTask(sharing.queue(), kernel(), 0, nullptr, nullptr), CL_INVALID_GL_OBJECT);
    ASSERT_EQ(sharing.acquire(shared), CL_SUCCESS);
    EXPECT_EQ(run(kernel), CL_SUCCESS);
    ASSERT_EQ(sharing.release(shared), CL_SUCCESS);
    EXPECT_EQ(run(kernel), CL_INVALID_GL_OBJECT);
    kernel.setArg(0, own);  // the shared one is no argument any more
    EXPECT_EQ(run(kernel), CL_SUCCESS);
    Bytes seen(1);
    clEnqueueReadBuffer(sharing.queue(), own(), CL_TRUE, 0, 1, seen.data(), 0, nullptr, nullptr);
    EXPECT_EQ(seen[0], 7);
}

TEST_P(Kernels, MadeAllAtOnceAreWatchedToo) {
    const cl::Memory shared = sharing.share_buffer(make_buffer(Bytes(64)));
    std::vector<cl::Kernel> all;
    program.createKernels(&all);
    ASSERT_EQ(all.size(), 2U);
    for (cl::Kernel &each : all) {
        each.setArg(0, shared);
        if (each.getInfo<CL_KERNEL_NUM_ARGS>() == 2) {
            each.setArg(1, cl_uint{1});
        }
        EXPECT_EQ(run(each), CL_INVALID_GL_OBJECT);
    }
}

TEST_P(Kernels, ForgetArgumentsThatDied) {
    {
        const cl::Memory shared = sharing.share_buffer(make_buffer(Bytes(64)));
        kernel.setArg(0, shared);
        EXPECT_EQ(run(kernel), CL_INVALID_GL_OBJECT);
    }
    const cl::Kernel again(kernel);  // a second reference, released first
    const cl::Buffer own(sharing.context, CL_MEM_READ_WRITE, 64);
    kernel.setArg(0, own);
    EXPECT_EQ(run(again), CL_SUCCESS);
}

}  // namespace
}  // namespace stagelight
