// SPDX-License-Identifier: MIT
// Which OpenCL device to use.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "device/opencl.h"

namespace stagelight {

// Every device of every platform, in the loader's order: the order of the indices.
std::vector<cl::Device> all_devices();

// Whether the device names the extension.
bool has_extension(const cl::Device &device, const char *extension);

bool is_gpu(const cl::Device &device);

// "0: NAME (PLATFORM, VERSION)", a line each; what to install when there is none.
std::string list_devices();

// `spec`, or where it is empty STAGELIGHT_DEVICE; empty where nobody names a device.
std::string named_device(const std::string &spec);

// The devices to try, one after the other. `spec` names one: an index, "cpu", "gpu" or a part of
// "NAME (PLATFORM, VERSION)", upper and lower case alike. An empty spec means STAGELIGHT_DEVICE,
// and where that is empty too, all devices, GPUs first. A device below OpenCL 1.2 is passed over,
// and so is one without images where `needs_images`: a line on stderr says so, unless it was
// named, which throws. Throws MachineError where none is left.
std::vector<cl::Device> devices_to_try(const std::string &spec, bool needs_images = false);

// The first of devices_to_try.
cl::Device choose_device(const std::string &spec);

// Calls `build` with one device after the other, until one of them doesn't throw a DeviceError or
// a cl::Error; each that does gives way to the next with a line on stderr. Returns the device.
// Throws what the last one threw.
cl::Device first_that_builds(const std::vector<cl::Device> &devices,
                             const std::function<void(const cl::Device &)> &build);

}  // namespace stagelight
