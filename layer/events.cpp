// SPDX-License-Identifier: MIT
// OpenCL Extension Specification, cl_khr_gl_event.
#include "events.h"

#include <CL/cl_gl.h>
#include <epoxy/gl.h>

#include "contexts.h"
#include "driver.h"
#include "layer.h"

namespace stagelight {
namespace {

// Waits here, not when the event is used: the event then needs no hold on the sync object, which
// the program may delete, and copying has to wait for the fence in any case. So the event is always
// complete; section 5.11.1 allows that.
cl_event event_from(cl_context context, GLsync sync) {
    sharing_context(context)->gl->require_current();
    require(glIsSync(sync) == GL_TRUE, CL_INVALID_GL_OBJECT,
            "there is no such GL sync object in the current OpenGL context");
    glClientWaitSync(sync, GL_SYNC_FLUSH_COMMANDS_BIT, GL_TIMEOUT_IGNORED);
    const cl_event event = made_by(driver->clCreateUserEvent, context);
    require(driver->clSetUserEventStatus(event, CL_COMPLETE));
    events.add(event,
               std::make_shared<EventRecord>(EventRecord{CL_COMMAND_GL_FENCE_SYNC_OBJECT_KHR}));
    return event;
}

cl_event CL_API_CALL create_event_from_sync(cl_context context, cl_GLsync sync,
                                            cl_int *errcode_ret) {
    return answer_handle(errcode_ret, [&] {
        if (belongs_to_driver(context)) {
            return made_by(driver->clCreateEventFromGLsyncKHR, context, sync);
        }
        require(offers_gl_event(), CL_INVALID_OPERATION, "cl_khr_gl_event is switched off");
        return event_from(context, sync);
    });
}

cl_int CL_API_CALL get_event_info(cl_event event, cl_event_info name, std::size_t size, void *value,
                                  std::size_t *size_ret) {
    const auto found = name == CL_EVENT_COMMAND_TYPE ? events.find(event) : nullptr;
    if (found == nullptr) {
        return driver->clGetEventInfo(event, name, size, value, size_ret);
    }
    return answer([&] { Query{size, value, size_ret}.give(&found->type, sizeof(found->type)); });
}

cl_int CL_API_CALL retain_event(cl_event event) {
    const cl_int code = driver->clRetainEvent(event);
    if (code == CL_SUCCESS) {
        events.retain(event);
    }
    return code;
}

cl_int CL_API_CALL release_event(cl_event event) {
    events.release(event);
    return driver->clReleaseEvent(event);
}

}  // namespace

bool EventRecord::is_gl_sync() const {
    return type == CL_COMMAND_GL_FENCE_SYNC_OBJECT_KHR;
}

void install_events(cl_icd_dispatch &table) {
    table.clCreateEventFromGLsyncKHR = create_event_from_sync;
    table.clGetEventInfo = get_event_info;
    table.clRetainEvent = retain_event;
    table.clReleaseEvent = release_event;
}

}  // namespace stagelight
