// SPDX-License-Identifier: MIT
// The one place that includes OpenCL: version 1.2, with exceptions, in every build type.
#pragma once

#define CL_HPP_ENABLE_EXCEPTIONS
#define CL_HPP_TARGET_OPENCL_VERSION 120
#define CL_HPP_MINIMUM_OPENCL_VERSION 120
#include <CL/opencl.hpp>

namespace stagelight {

// Newer headers give getInfo<CL_DEVICE_PLATFORM>() as a cl::Platform, older ones as its id.
inline cl::Platform platform_of(const cl::Device &device) {
    cl::Platform platform;
    device.getInfo(CL_DEVICE_PLATFORM, &platform);
    return platform;
}

}  // namespace stagelight
