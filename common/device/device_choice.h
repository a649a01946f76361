// SPDX-License-Identifier: MIT
// Which OpenCL device to use.
#pragma once

#include <string>
#include <vector>

#include "device/opencl.h"

namespace stagelight {

// Every device of every platform, in the loader's order: the order of the indices.
std::vector<cl::Device> all_devices();

// Whether the device names the extension.
bool has_extension(const cl::Device &device, const char *extension);

// "0: NAME (PLATFORM, VERSION)", a line each; what to install when there is none.
std::string list_devices();

// `spec`, or where it is empty STAGELIGHT_DEVICE; empty where nobody names a device.
std::string named_device(const std::string &spec);

// The device that `spec` stands for: an index, "cpu", "gpu" or a part of its name (upper and
// lower case are one). An empty spec means STAGELIGHT_DEVICE, and where that is empty too,
// the first GPU, else the first device. Throws MachineError with the list of those there are.
cl::Device choose_device(const std::string &spec);

}  // namespace stagelight
