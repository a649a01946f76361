// SPDX-License-Identifier: MIT
// What acquire and release wait for, and what they give the program to wait for.
#pragma once

#include <vector>

#include <CL/cl.h>

namespace stagelight {

struct WaitList {
    cl_uint count;
    const cl_event *events;

    // Throws Refusal CL_INVALID_EVENT_WAIT_LIST.
    WaitList(cl_uint wait_count, const cl_event *wait_events);
    void wait() const;  // throws Refusal, also when one of the events failed
    // Throws Refusal CL_INVALID_EVENT when one was made from a GL sync object: only acquire may
    // wait for those (cl_khr_gl_event, section 5.11.1).
    void require_no_gl_sync() const;
};

// The events of the copies of one call, and what becomes one event of them for the program.
class TransferEvents {
public:
    TransferEvents() = default;
    ~TransferEvents();
    TransferEvents(const TransferEvents &) = delete;
    TransferEvents &operator=(const TransferEvents &) = delete;

    cl_event *next();  // where a copy puts its event; good until the next call
    void wait() const;
    // `event` may be null: then there is nothing to give. `type` is what it says it is.
    void give(cl_command_queue queue, cl_command_type type, cl_event *event) const;

private:
    std::vector<cl_event> events_;
};

}  // namespace stagelight
