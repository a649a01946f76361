// SPDX-License-Identifier: MIT
// Which shared objects are arguments of which kernel.
#pragma once

#include <map>
#include <memory>

#include <CL/cl.h>

#include "objects.h"
#include "records.h"

namespace stagelight {

struct KernelRecord {
    // By the number of the argument. The objects may die before the kernel.
    std::map<cl_uint, std::weak_ptr<SharedObject>> arguments;
};

inline auto &kernels = *new Records<cl_kernel, KernelRecord>;

}  // namespace stagelight
