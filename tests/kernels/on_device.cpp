// SPDX-License-Identifier: MIT
#include "kernels/on_device.h"

#include "device/kernel_source.h"
#include "device/program.h"

namespace stagelight {

DeviceProgram::DeviceProgram(const cl::Device &device, const std::string &file,
                             const SceneNeeds &needs, const Methods &methods, Transfer decode)
    : device_(device), context_(device_), queue_(context_, device_),
      program_(build_program(context_,
                             kernel_source("tests/kernels/" + file, {}, files_of(methods, needs)),
                             build_options(device_, needs, methods))),
      decode_(decode) {}

}  // namespace stagelight
