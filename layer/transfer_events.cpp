// SPDX-License-Identifier: MIT
#include "transfer_events.h"

#include <algorithm>

#include "driver.h"
#include "events.h"

namespace stagelight {

WaitList::WaitList(cl_uint wait_count, const cl_event *wait_events)
    : count(wait_count), events(wait_events) {
    require((count == 0) == (events == nullptr), CL_INVALID_EVENT_WAIT_LIST,
            "the number of events does not fit their list");
}

void WaitList::wait() const {
    if (count > 0) {
        const cl_int code = driver->clWaitForEvents(count, events);
        require(code == CL_INVALID_EVENT ? CL_INVALID_EVENT_WAIT_LIST : code);
    }
}

void WaitList::require_no_gl_sync() const {
    const auto is_gl_sync = [](cl_event event) {
        const auto record = stagelight::events.find(event);
        return record != nullptr && record->is_gl_sync();
    };
    require(std::none_of(events, events + count, is_gl_sync), CL_INVALID_EVENT,
            "of commands, only clEnqueueAcquireGLObjects may wait for the event of a GL sync");
}

TransferEvents::~TransferEvents() {
    for (const cl_event each : events_) {
        if (each != nullptr) {
            driver->clReleaseEvent(each);
        }
    }
}

cl_event *TransferEvents::next() {
    return &events_.emplace_back(nullptr);
}

void TransferEvents::wait() const {
    require(driver->clWaitForEvents(static_cast<cl_uint>(events_.size()), events_.data()));
}

void TransferEvents::give(cl_command_queue queue, cl_command_type type, cl_event *event) const {
    if (event != nullptr) {
        require(driver->clEnqueueMarkerWithWaitList(queue, static_cast<cl_uint>(events_.size()),
                                                    events_.data(), event));
        events.add(*event, std::make_shared<EventRecord>(EventRecord{type}));
    }
}

}  // namespace stagelight
