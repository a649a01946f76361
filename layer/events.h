// SPDX-License-Identifier: MIT
// The events that mean something else to the program than to the driver.
#pragma once

#include <CL/cl.h>

#include "records.h"

namespace stagelight {

struct EventRecord {
    cl_command_type type;
    bool is_gl_sync() const;
};

inline auto &events = *new Records<cl_event, EventRecord>;

}  // namespace stagelight
