// SPDX-License-Identifier: MIT
#include "driver.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <sstream>

namespace stagelight {

void Query::give(const void *data, std::size_t bytes) const {
    require(value == nullptr || size >= bytes, CL_INVALID_VALUE,
            "the room for a query's result is too small");
    if (value != nullptr && bytes > 0) {
        std::memcpy(value, data, bytes);
    }
    if (size_ret != nullptr) {
        *size_ret = bytes;
    }
}

std::string device_text(cl_device_id device, cl_device_info name) {
    std::size_t size = 0;
    require(driver->clGetDeviceInfo(device, name, 0, nullptr, &size));
    std::string text(size, '\0');
    require(driver->clGetDeviceInfo(device, name, size, text.data(), nullptr));
    text.resize(std::strlen(text.data()));  // without the terminating zero
    return text;
}

std::vector<cl_device_id> devices_of(cl_platform_id platform, cl_device_type type) {
    cl_uint count = 0;
    const cl_int code = driver->clGetDeviceIDs(platform, type, 0, nullptr, &count);
    if (code == CL_DEVICE_NOT_FOUND) {
        return {};
    }
    require(code);
    std::vector<cl_device_id> devices(count);
    require(driver->clGetDeviceIDs(platform, type, count, devices.data(), nullptr));
    return devices;
}

cl_context context_of(cl_command_queue queue) {
    cl_context context = nullptr;
    require(
        driver->clGetCommandQueueInfo(queue, CL_QUEUE_CONTEXT, sizeof(context), &context, nullptr));
    return context;
}

cl_context context_of(cl_mem object) {
    cl_context context = nullptr;
    require(driver->clGetMemObjectInfo(object, CL_MEM_CONTEXT, sizeof(context), &context, nullptr));
    return context;
}

bool names_extension(const std::string &list, const std::string &name) {
    std::istringstream words(list);
    using Words = std::istream_iterator<std::string>;
    return std::find(Words(words), Words(), name) != Words();
}

bool shares_itself(cl_device_id device) {
    return names_extension(device_text(device, CL_DEVICE_EXTENSIONS), "cl_khr_gl_sharing");
}

bool shares_itself(cl_context context) {
    std::size_t size = 0;
    require(driver->clGetContextInfo(context, CL_CONTEXT_DEVICES, 0, nullptr, &size));
    std::vector<cl_device_id> devices(size / sizeof(cl_device_id));
    require(driver->clGetContextInfo(context, CL_CONTEXT_DEVICES, size, devices.data(), nullptr));
    return std::ranges::all_of(devices, [](cl_device_id each) { return shares_itself(each); });
}

bool is_served(cl_device_id device) {
    // "OpenCL 1.2 …": section 4.2 of the OpenCL specification fixes the form.
    const std::string version = device_text(device, CL_DEVICE_VERSION);
    return version.substr(0, 10) >= "OpenCL 1.2" && !shares_itself(device);
}

bool serves_some(const std::vector<cl_device_id> &devices) {
    return std::ranges::any_of(devices, is_served);
}

}  // namespace stagelight
