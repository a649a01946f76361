// SPDX-License-Identifier: MIT
// OpenCL C, compiled for a device.
#pragma once

#include <string>

#include "device/methods.h"
#include "device/opencl.h"
#include "device/scene_needs.h"

namespace stagelight {

// Whether kernels of those methods calculate in double.
bool is_double(const Methods &methods);

// What any kernel is built with for that device: the version of OpenCL C.
std::string language_of(const cl::Device &device);

// -cl-std and the names that kernels/ are built with for a scene, its methods and what the device
// has. Throws DeviceError for a method that the device lacks.
std::string build_options(const cl::Device &device, const SceneNeeds &needs,
                          const Methods &methods);

// Builds `source`. Where it does not build, throws the log: as a KernelError if it was read
// `from_disk` (the user's own work), else as a DeviceError.
cl::Program build_program(const cl::Context &context, const std::string &source,
                          const std::string &options, bool from_disk = false);

}  // namespace stagelight
