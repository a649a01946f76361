// SPDX-License-Identifier: MIT
#include "contexts.h"

#include <algorithm>
#include <functional>

#include <CL/cl_gl.h>

#include "context_properties.h"
#include "driver.h"
#include "layer.h"
#include "refusal.h"

namespace stagelight {
namespace {

using Notify = void(CL_CALLBACK *)(const char *, const void *, std::size_t, void *);

void remember(cl_context handle, std::vector<cl_context_properties> properties,
              std::unique_ptr<GlContext> gl) {
    contexts.add(handle, std::make_shared<SharingContext>(
                             SharingContext{handle, std::move(properties), std::move(gl)}));
}

// `make` asks the driver for a context of `devices` with the properties it is given.
template <typename Make>
cl_context create(const cl_context_properties *list, const std::vector<cl_device_id> &devices,
                  Make make) {
    ContextProperties properties(list);
    const auto shares = [](cl_device_id each) { return shares_itself(each); };
    const bool drivers = !devices.empty() && std::ranges::all_of(devices, shares);
    if (!properties.name_gl() || drivers) {
        return make(list);
    }
    std::unique_ptr<GlContext> gl = named_gl_context(properties);
    // "Any of the devices … cannot support OpenCL objects which share the data store of an OpenGL
    // object."
    const auto can_share = [&](cl_device_id each) { return shares(each) || is_served(each); };
    require(gl == nullptr || std::ranges::all_of(devices, can_share), CL_INVALID_OPERATION,
            "the layer needs devices of OpenCL 1.2 or later");
    if (gl != nullptr) {
        gl->mark_if_current();
    }
    const cl_context handle = make(properties.others.data());
    if (gl != nullptr) {
        remember(handle, std::move(properties.all), std::move(gl));
    }
    return handle;
}

cl_context CL_API_CALL create_context(const cl_context_properties *list, cl_uint count,
                                      const cl_device_id *devices, Notify notify, void *user_data,
                                      cl_int *errcode_ret) {
    const auto make = [=](const cl_context_properties *properties) {
        return made_by(driver->clCreateContext, properties, count, devices, notify, user_data);
    };
    return answer_handle(errcode_ret, [&] {
        return devices == nullptr ? make(list) : create(list, {devices, devices + count}, make);
    });
}

cl_context CL_API_CALL create_context_from_type(const cl_context_properties *list,
                                                cl_device_type type, Notify notify, void *user_data,
                                                cl_int *errcode_ret) {
    const auto make = [=](const cl_context_properties *properties) {
        return made_by(driver->clCreateContextFromType, properties, type, notify, user_data);
    };
    return answer_handle(errcode_ret, [&] {
        const cl_platform_id platform = ContextProperties(list).platform;
        return platform == nullptr ? make(list) : create(list, devices_of(platform, type), make);
    });
}

cl_int CL_API_CALL retain_context(cl_context context) {
    const cl_int code = driver->clRetainContext(context);
    if (code == CL_SUCCESS) {
        contexts.retain(context);
    }
    return code;
}

cl_int CL_API_CALL release_context(cl_context context) {
    contexts.release(context);
    return driver->clReleaseContext(context);
}

cl_int CL_API_CALL get_context_info(cl_context context, cl_context_info name, std::size_t size,
                                    void *value, std::size_t *size_ret) {
    const auto found = name == CL_CONTEXT_PROPERTIES ? contexts.find(context) : nullptr;
    if (found == nullptr) {
        return driver->clGetContextInfo(context, name, size, value, size_ret);
    }
    return answer([&] {
        const std::vector<cl_context_properties> &list = found->properties;
        Query{size, value, size_ret}.give(list.data(), list.size() * sizeof(list[0]));
    });
}

void give_devices(const std::vector<cl_device_id> &devices, cl_gl_context_info name,
                  const Query &query) {
    switch (name) {
    case CL_CURRENT_DEVICE_FOR_GL_CONTEXT_KHR:
        return query.give(devices.data(),
                          std::min<std::size_t>(devices.size(), 1) * sizeof(cl_device_id));
    case CL_DEVICES_FOR_GL_CONTEXT_KHR:
        return query.give(devices.data(), devices.size() * sizeof(cl_device_id));
    default:
        throw Refusal{CL_INVALID_VALUE, "clGetGLContextInfoKHR does not know what it is asked"};
    }
}

// Copying works with any OpenGL context, so every device of the platform that is served may be
// associated with it, and one is as current as another: the first.
cl_int CL_API_CALL get_gl_context_info(const cl_context_properties *list, cl_gl_context_info name,
                                       std::size_t size, void *value, std::size_t *size_ret) {
    return answer([&] {
        const ContextProperties properties(list);
        require(properties.platform != nullptr, CL_INVALID_PLATFORM,
                "clGetGLContextInfoKHR needs CL_CONTEXT_PLATFORM");
        std::vector<cl_device_id> devices = devices_of(properties.platform, CL_DEVICE_TYPE_ALL);
        const auto shares = [](cl_device_id each) { return shares_itself(each); };
        if (std::ranges::any_of(devices, shares)) {
            return require(driver->clGetGLContextInfoKHR(list, name, size, value, size_ret));
        }
        // Beside those of OpenGL the platform alone, and the last 0.
        require(properties.others.size() == 3, CL_INVALID_VALUE,
                "clGetGLContextInfoKHR does not know one of the properties");
        require(named_gl_context(properties) != nullptr, CL_INVALID_GL_SHAREGROUP_REFERENCE_KHR,
                "the properties name no OpenGL context");
        std::erase_if(devices, std::not_fn(is_served));
        give_devices(devices, name, Query{size, value, size_ret});
    });
}

}  // namespace

std::shared_ptr<SharingContext> sharing_context(cl_context context) {
    auto found = contexts.find(context);
    require(found != nullptr, CL_INVALID_CONTEXT,
            "the OpenCL context was not made from an OpenGL context");
    return found;
}

bool belongs_to_driver(cl_context context) {
    return contexts.find(context) == nullptr && shares_itself(context);
}

void install_contexts(cl_icd_dispatch &table) {
    table.clCreateContext = create_context;
    table.clCreateContextFromType = create_context_from_type;
    table.clRetainContext = retain_context;
    table.clReleaseContext = release_context;
    table.clGetContextInfo = get_context_info;
    table.clGetGLContextInfoKHR = get_gl_context_info;
}

}  // namespace stagelight
