// SPDX-License-Identifier: MIT
// With STAGELIGHT_LAYER_GL_EVENT=0 a program has to go the way of glFinish.
#include "layer/sharing.h"

namespace stagelight {
namespace {

const bool switched_off = setenv("STAGELIGHT_LAYER_GL_EVENT", "0", 1) == 0;

using WithoutGlEvent = OnEach;
STAGELIGHT_ON_EACH(WithoutGlEvent);

TEST_P(WithoutGlEvent, SharesAllTheSame) {
    ASSERT_TRUE(switched_off);
    const Sharing sharing(GetParam());
    const auto of_device = sharing.device.getInfo<CL_DEVICE_EXTENSIONS>();
    const auto of_platform = sharing.platform.getInfo<CL_PLATFORM_EXTENSIONS>();
    for (const std::string &extensions : {of_device, of_platform}) {
        EXPECT_NE(extensions.find("cl_khr_gl_sharing"), std::string::npos);
        EXPECT_EQ(extensions.find("cl_khr_gl_event"), std::string::npos);
    }
    const cl::Memory image = sharing.share(make_texture(4, 4, {}));
    glFinish();
    EXPECT_EQ(sharing.acquire(image), CL_SUCCESS);
    EXPECT_EQ(sharing.release(image), CL_SUCCESS);
}

TEST_P(WithoutGlEvent, MakesNoEventOfAFence) {
    const Sharing sharing(GetParam());
    const GLsync sync = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    cl_int code = CL_SUCCESS;
    EXPECT_EQ(clCreateEventFromGLsyncKHR(sharing.context(), sync, &code), nullptr);
    EXPECT_EQ(code, CL_INVALID_OPERATION);
}

}  // namespace
}  // namespace stagelight
