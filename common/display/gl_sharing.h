// SPDX-License-Identifier: MIT
// An OpenCL context that shares with the OpenGL context of the window (cl_khr_gl_sharing).
#pragma once

#include <optional>
#include <string>

#include "device/opencl.h"
#include "display/window.h"

namespace stagelight {

// The first device, of all platforms, that drives the current OpenGL context and can share with it.
std::optional<cl::Device> device_of_gl_context(ContextApi api);

// The device that is named (named_device), else the one of device_of_gl_context, else the one that
// choose_device takes. Throws as that.
cl::Device device_to_share(const std::string &spec, ContextApi api);

// A context of `device` that shares with the current OpenGL context, whose API is `api`. Throws
// RungLost with the reason when there can be none.
cl::Context shared_context(const cl::Device &device, ContextApi api);

}  // namespace stagelight
