// SPDX-License-Identifier: MIT
// An OpenCL context that shares with the OpenGL context of the window (cl_khr_gl_sharing).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "device/opencl.h"
#include "display/window.h"

namespace stagelight {

// The first device, of all platforms, that drives the current OpenGL context and can share with it.
std::optional<cl::Device> device_of_gl_context(ContextApi api);

// devices_to_try, the one of device_of_gl_context first where it is among them. Throws as that.
std::vector<cl::Device> devices_to_share(const std::string &spec, ContextApi api,
                                         bool needs_images = false);

// A context of `device` that shares with the current OpenGL context, whose API is `api`. Throws
// PresenterLost with the reason when there can be none.
cl::Context shared_context(const cl::Device &device, ContextApi api);

}  // namespace stagelight
