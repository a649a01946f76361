// SPDX-License-Identifier: MIT
// What the layer remembers goes with the program's objects.
#include <dlfcn.h>

#include <chrono>
#include <thread>

#include "layer/sharing.h"

namespace stagelight {
namespace {

using Lifetime = OnEach;
STAGELIGHT_ON_EACH(Lifetime);

std::size_t records() {
    void *const library = dlopen(STAGELIGHT_LAYER, RTLD_LAZY | RTLD_NOLOAD);
    EXPECT_NE(library, nullptr);
    const auto count =
        reinterpret_cast<std::size_t (*)()>(dlsym(library, "stagelight_gl_sharing_records"));
    const std::size_t result = count();
    dlclose(library);
    return result;
}

TEST_P(Lifetime, TenThousandFramesLeaveNothing) {
    const Sharing sharing(GetParam());
    const cl::Memory image = sharing.share(make_texture(2, 2, {}));
    const std::size_t before = records();
    for (int frame = 0; frame < 10000; ++frame) {
        cl::Event acquired;
        cl::Event released;
        ASSERT_EQ(sharing.acquire(image, &acquired()), CL_SUCCESS);
        ASSERT_EQ(sharing.release(image, &released()), CL_SUCCESS);
        released.wait();
    }
    EXPECT_EQ(records(), before);
}

// What still runs, here or of the test before, keeps what it needs until it is done.
void wait_for_records(std::size_t expected) {
    for (int i = 0; i < 1000 && records() != expected; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
}

TEST_P(Lifetime, ObjectsOfEveryKindLeaveNothing) {
    ASSERT_NE(device_named(GetParam())(), nullptr);  // loads the layer
    wait_for_records(0);
    const std::size_t before = records();
    for (int round = 0; round < 6; ++round) {
        const Sharing sharing(GetParam());
        const cl::Memory image = sharing.share(make_texture(4, 4, {}));
        const cl::Memory buffer = sharing.share_buffer(make_buffer(Bytes(4096)));
        const cl_buffer_region region{0, 64};
        const cl::Memory part(clCreateSubBuffer(buffer(), CL_MEM_READ_WRITE,
                                                CL_BUFFER_CREATE_TYPE_REGION, &region, nullptr),
                              false);
        cl::Program program(sharing.context, "kernel void touch(global uchar *to) { *to = 1; }");
        program.build();
        cl::Kernel kernel(program, "touch");
        kernel.setArg(0, buffer);
        const cl::Kernel second_reference(kernel);
        ASSERT_EQ(sharing.acquire(buffer), CL_SUCCESS);
        sharing.queue.enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(1));
        cl::Event released;
        ASSERT_EQ(sharing.release(buffer, &released()), CL_SUCCESS);
        const cl::Event another_reference(released);
        EXPECT_GT(records(), before);
    }
    wait_for_records(before);
    EXPECT_EQ(records(), before);
}

// As when a C++ program's queue and images outlive its cl::Context.
TEST_P(Lifetime, ObjectsMayOutliveTheContextsHandle) {
    Sharing sharing(GetParam());
    const Bytes pixels = random_bytes(64, 1);
    const cl::Memory image = sharing.share(make_texture(4, 4, pixels));
    sharing.context = cl::Context();
    EXPECT_EQ(sharing.acquire(image), CL_SUCCESS);
    EXPECT_EQ(sharing.read_image(image, 4, {4, 4, 1}), pixels);
    EXPECT_EQ(sharing.release(image), CL_SUCCESS);
}

}  // namespace
}  // namespace stagelight
