// SPDX-License-Identifier: MIT
// What lies below this layer, and what the layer asks of it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <CL/cl_icd.h>

#include "refusal.h"

namespace stagelight {

// The next layer, or the loader's way to the drivers. Set by clInitLayer, before any other call.
inline const cl_icd_dispatch *driver = nullptr;

// Where the result of a clGet…Info goes.
struct Query {
    std::size_t size;
    void *value;
    std::size_t *size_ret;

    // Throws Refusal: CL_INVALID_VALUE when there is too little room.
    void give(const void *data, std::size_t bytes) const;
};

// What a creating function of the driver makes; its error as a Refusal.
template <typename Function, typename... Arguments>
auto made_by(Function function, Arguments... arguments) {
    cl_int code = CL_SUCCESS;
    const auto handle = function(arguments..., &code);
    require(code);
    return handle;
}

// These throw Refusal with the driver's code.
std::string device_text(cl_device_id device, cl_device_info name);
std::vector<cl_device_id> devices_of(cl_platform_id platform, cl_device_type type);
cl_context context_of(cl_command_queue queue);
cl_context context_of(cl_mem object);

// Whether a list as in CL_DEVICE_EXTENSIONS has the name.
bool names_extension(const std::string &list, const std::string &name);

// Whether a device has cl_khr_gl_sharing of its own. Such a device is none of the layer's business.
bool shares_itself(cl_device_id device);
bool shares_itself(cl_context context);  // all its devices do
// Whether the layer shares for it: not one that does so itself, nor one before OpenCL 1.2, which
// lacks the functions that the layer uses.
bool is_served(cl_device_id device);
bool serves_some(const std::vector<cl_device_id> &devices);

}  // namespace stagelight
