// SPDX-License-Identifier: MIT
#include "display/gl_sharing.h"

#include <algorithm>
#include <vector>

#include <epoxy/egl.h>
#include <epoxy/glx.h>
#include <fmt/format.h>

#include "device/device_choice.h"
#include "display/presenter.h"

namespace stagelight {
namespace {

using Properties = std::vector<cl_context_properties>;

template <typename Handle> cl_context_properties property(Handle handle) {
    return reinterpret_cast<cl_context_properties>(handle);
}

// #region properties_of
// The current OpenGL context and the display that it lives on (OpenCL Extension Specification,
// cl_khr_gl_sharing, "CL Context > GL Context").
Properties properties_of(const cl::Platform &platform, ContextApi api) {
    Properties properties{CL_CONTEXT_PLATFORM, property(platform())};
    if (api == ContextApi::egl) {
        properties.insert(properties.end(), {CL_GL_CONTEXT_KHR, property(eglGetCurrentContext()),
                                             CL_EGL_DISPLAY_KHR, property(eglGetCurrentDisplay())});
    } else {
        properties.insert(properties.end(), {CL_GL_CONTEXT_KHR, property(glXGetCurrentContext()),
                                             CL_GLX_DISPLAY_KHR, property(glXGetCurrentDisplay())});
    }
    properties.push_back(0);
    return properties;
}
// #endregion properties_of

std::vector<cl::Device> ask(clGetGLContextInfoKHR_fn get_info, const Properties &properties,
                            cl_gl_context_info what) {
    std::vector<cl_device_id> ids(all_devices().size());
    std::size_t size = 0;
    const cl_int error =
        get_info(properties.data(), what, ids.size() * sizeof(cl_device_id), ids.data(), &size);
    if (error != CL_SUCCESS) {
        throw PresenterLost(fmt::format("clGetGLContextInfoKHR failed with error {}", error));
    }
    ids.resize(size / sizeof(cl_device_id));
    std::vector<cl::Device> devices;
    devices.reserve(ids.size());
    for (cl_device_id id : ids) {
        devices.emplace_back(id, true);
    }
    return devices;
}

clGetGLContextInfoKHR_fn info_function(const cl::Platform &platform) {
    const auto get_info = reinterpret_cast<clGetGLContextInfoKHR_fn>(
        clGetExtensionFunctionAddressForPlatform(platform(), "clGetGLContextInfoKHR"));
    if (get_info == nullptr) {
        throw PresenterLost(
            fmt::format("{} has no clGetGLContextInfoKHR", platform.getInfo<CL_PLATFORM_NAME>()));
    }
    return get_info;
}

void require_same_device(const cl::Device &device, const Properties &properties) {
    const std::vector<cl::Device> sharing =
        ask(info_function(platform_of(device)), properties, CL_DEVICES_FOR_GL_CONTEXT_KHR);
    if (std::ranges::none_of(sharing, [&](const cl::Device &d) { return d() == device(); })) {
        throw PresenterLost(fmt::format(
            "{} does not drive this display{}", device.getInfo<CL_DEVICE_NAME>(),
            sharing.empty() ? "" : ", " + sharing.front().getInfo<CL_DEVICE_NAME>() + " does"));
    }
}

}  // namespace

std::optional<cl::Device> device_of_gl_context(ContextApi api) {
    for (const cl::Device &device : all_devices()) {
        try {
            if (has_extension(device, "cl_khr_gl_sharing")) {
                const cl::Platform platform = platform_of(device);
                const std::vector<cl::Device> current =
                    ask(info_function(platform), properties_of(platform, api),
                        CL_CURRENT_DEVICE_FOR_GL_CONTEXT_KHR);
                if (!current.empty()) {
                    return current.front();
                }
            }
        } catch (const PresenterLost &) {
            continue;  // not this platform's context
        }
    }
    return std::nullopt;
}

std::vector<cl::Device> devices_to_share(const std::string &spec, ContextApi api,
                                         bool needs_images) {
    std::vector<cl::Device> devices = devices_to_try(spec, needs_images);
    if (const std::optional<cl::Device> sharing = device_of_gl_context(api)) {
        std::stable_partition(devices.begin(), devices.end(),
                              [&](const cl::Device &device) { return device() == (*sharing)(); });
    }
    return devices;
}

cl::Context shared_context(const cl::Device &device, ContextApi api) {
    if (!has_extension(device, "cl_khr_gl_sharing")) {
        throw PresenterLost(device.getInfo<CL_DEVICE_NAME>() + " has no cl_khr_gl_sharing");
    }
    Properties properties = properties_of(platform_of(device), api);
    require_same_device(device, properties);
    try {
        return {device, properties.data()};
    } catch (const cl::Error &error) {
        throw PresenterLost(
            fmt::format("no shared context: {} failed with error {}", error.what(), error.err()));
    }
}

}  // namespace stagelight
