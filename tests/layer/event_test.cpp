// SPDX-License-Identifier: MIT
// The events of acquire and release, and those of OpenGL's sync objects: cl_khr_gl_event.
#include "layer/sharing.h"

namespace stagelight {
namespace {

using Events = OnEach;
STAGELIGHT_ON_EACH(Events);

template <typename Value> Value info(const cl::Event &event, cl_event_info name) {
    Value value{};
    EXPECT_EQ(clGetEventInfo(event(), name, sizeof(value), &value, nullptr), CL_SUCCESS);
    return value;
}

TEST_P(Events, OfAcquireAndReleaseSayWhatTheyAre) {
    const Sharing sharing(GetParam());
    const cl::Memory image = sharing.share(make_texture(4, 4, {}));
    cl::Event acquired;
    cl::Event released;
    ASSERT_EQ(sharing.acquire(image, &acquired()), CL_SUCCESS);
    ASSERT_EQ(sharing.release(image, &released()), CL_SUCCESS);
    released.wait();
    for (const cl::Event &each : {acquired, released}) {
        EXPECT_EQ(info<cl_int>(each, CL_EVENT_COMMAND_EXECUTION_STATUS), CL_COMPLETE);
        EXPECT_EQ(info<cl_command_queue>(each, CL_EVENT_COMMAND_QUEUE), sharing.queue());
        EXPECT_EQ(info<cl_context>(each, CL_EVENT_CONTEXT), sharing.context());
    }
    EXPECT_EQ(info<cl_command_type>(acquired, CL_EVENT_COMMAND_TYPE),
              static_cast<cl_command_type>(CL_COMMAND_ACQUIRE_GL_OBJECTS));
    EXPECT_EQ(info<cl_command_type>(released, CL_EVENT_COMMAND_TYPE),
              static_cast<cl_command_type>(CL_COMMAND_RELEASE_GL_OBJECTS));
}

TEST_P(Events, OfAFailedAcquireAreNone) {
    const Sharing sharing(GetParam());
    const cl::Memory image = sharing.share(make_texture(4, 4, {}));
    cl_event event = nullptr;
    EXPECT_EQ(sharing.release(image, &event), CL_INVALID_OPERATION);
    EXPECT_EQ(event, nullptr);
}

TEST_P(Events, ThatFailedAreNotWaitedForInVain) {
    const Sharing sharing(GetParam());
    const cl::Memory image = sharing.share(make_texture(4, 4, {}));
    cl::UserEvent failed(sharing.context);
    failed.setStatus(-1);
    EXPECT_EQ(clEnqueueAcquireGLObjects(sharing.queue(), 1, &image(), 1, &failed(), nullptr),
              CL_EXEC_STATUS_ERROR_FOR_EVENTS_IN_WAIT_LIST);
    EXPECT_EQ(sharing.acquire(image), CL_SUCCESS);  // it was left alone
}

// An event of a fence behind what OpenGL was told so far.
cl::Event event_of_fence(const Sharing &sharing) {
    const GLsync sync = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    cl_int code = CL_SUCCESS;
    const cl::Event event(clCreateEventFromGLsyncKHR(sharing.context(), sync, &code), false);
    EXPECT_EQ(code, CL_SUCCESS);
    glDeleteSync(sync);  // the event does not need it any more
    return event;
}

TEST_P(Events, OfAGlSyncSayWhatTheyAre) {
    const Sharing sharing(GetParam());
    const cl::Event event = event_of_fence(sharing);
    EXPECT_EQ(info<cl_command_type>(event, CL_EVENT_COMMAND_TYPE),
              static_cast<cl_command_type>(CL_COMMAND_GL_FENCE_SYNC_OBJECT_KHR));
    EXPECT_EQ(info<cl_command_queue>(event, CL_EVENT_COMMAND_QUEUE), nullptr);
    const auto status = info<cl_int>(event, CL_EVENT_COMMAND_EXECUTION_STATUS);
    EXPECT_TRUE(status == CL_SUBMITTED || status == CL_COMPLETE) << status;
    event.wait();
}

TEST_P(Events, OfAGlSyncAreForAcquireAlone) {
    const Sharing sharing(GetParam());
    const cl::Memory image = sharing.share(make_texture(4, 4, {}));
    const cl::Event event = event_of_fence(sharing);
    const cl::Buffer own(sharing.context, CL_MEM_READ_WRITE, 64);
    const cl_command_queue queue = sharing.queue();
    Bytes bytes(64);
    EXPECT_EQ(clEnqueueReadBuffer(queue, own(), CL_TRUE, 0, 64, bytes.data(), 1, &event(), nullptr),
              CL_INVALID_EVENT);
    EXPECT_EQ(clEnqueueMarkerWithWaitList(queue, 1, &event(), nullptr), CL_INVALID_EVENT);
    EXPECT_EQ(clEnqueueBarrierWithWaitList(queue, 1, &event(), nullptr), CL_INVALID_EVENT);
    cl_int code = CL_SUCCESS;
    EXPECT_EQ(
        clEnqueueMapBuffer(queue, own(), CL_TRUE, CL_MAP_READ, 0, 64, 1, &event(), nullptr, &code),
        nullptr);
    EXPECT_EQ(code, CL_INVALID_EVENT);
    EXPECT_EQ(clEnqueueAcquireGLObjects(queue, 1, &image(), 1, &event(), nullptr), CL_SUCCESS);
    EXPECT_EQ(clEnqueueReleaseGLObjects(queue, 1, &image(), 1, &event(), nullptr),
              CL_INVALID_EVENT);
    EXPECT_EQ(sharing.release(image), CL_SUCCESS);  // it was left alone
}

TEST_P(Events, NeedAGlSync) {
    const Sharing sharing(GetParam());
    cl_int code = CL_SUCCESS;
    EXPECT_EQ(clCreateEventFromGLsyncKHR(sharing.context(), nullptr, &code), nullptr);
    EXPECT_EQ(code, CL_INVALID_GL_OBJECT);
    const GLsync sync = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    glDeleteSync(sync);
    EXPECT_EQ(clCreateEventFromGLsyncKHR(sharing.context(), sync, &code), nullptr);
    EXPECT_EQ(code, CL_INVALID_GL_OBJECT);
}

}  // namespace
}  // namespace stagelight
