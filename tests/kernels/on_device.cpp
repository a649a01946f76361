// SPDX-License-Identifier: MIT
#include "kernels/on_device.h"

#include <algorithm>
#include <cstdlib>

#include "device/device_choice.h"
#include "device/kernel_source.h"
#include "scene/errors.h"

namespace stagelight {

cl::Device device_of(const std::string &platform) {
    setenv("RUSTICL_ENABLE", "llvmpipe", 1);  // read at the process's first OpenCL call
    const std::vector<cl::Device> devices = all_devices();
    const auto found = std::ranges::find_if(devices, [&](const cl::Device &device) {
        const cl::Platform its(device.getInfo<CL_DEVICE_PLATFORM>());
        return its.getInfo<CL_PLATFORM_NAME>().find(platform) != std::string::npos;
    });
    if (found == devices.end()) {
        throw MachineError("expected a device of " + platform + " (packages.txt); there are:\n"
                           + list_devices());
    }
    return *found;
}

DeviceProgram::DeviceProgram(const cl::Device &device, const std::string &file,
                             const SceneNeeds &needs, const Methods &methods)
    : device_(device), context_(device_), queue_(context_, device_),
      program_(build_program(context_, kernel_source("tests/kernels/" + file),
                             build_options(needs, methods))) {}

}  // namespace stagelight
