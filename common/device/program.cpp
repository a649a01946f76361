// SPDX-License-Identifier: MIT
#include "device/program.h"

#include <fmt/format.h>

#include "device/device_choice.h"
#include "scene/errors.h"

namespace stagelight {
namespace {

// ": " and the first line of what a compiler said, which `log` has after ":\n".
std::string first_line_of(const std::string &log) {
    const std::size_t begin = log.find_first_not_of(":\n ");
    return begin == std::string::npos ? ""
                                      : ": " + log.substr(begin, log.find('\n', begin) - begin);
}

}  // namespace

bool is_double(const Methods &methods) {
    return choice(methods, "math") == "fp64";
}

// Images are part of OpenCL C 1.2, but the header of LLVM 21 (in PoCL 7.1) declares their functions
// only where the name of a feature of OpenCL C 3.0 is defined.
std::string language_of(const cl::Device &device) {
    const bool has_images = device.getInfo<CL_DEVICE_IMAGE_SUPPORT>() == CL_TRUE;
    return std::string("-cl-std=CL1.2") + (has_images ? " -D __opencl_c_images=1" : "");
}

std::string build_options(const cl::Device &device, const SceneNeeds &needs,
                          const Methods &methods) {
    std::string options = language_of(device) + " -cl-kernel-arg-info";
    if (is_double(methods) && !has_extension(device, "cl_khr_fp64")) {
        throw DeviceError(fmt::format("--method math=fp64: {} has no cl_khr_fp64; choose another "
                                      "device (--list-devices), or math=strict",
                                      device.getInfo<CL_DEVICE_NAME>()),
                          "it has no cl_khr_fp64, which math=fp64 needs");
    }
    const cl_device_fp_config config = is_double(methods)
                                           ? device.getInfo<CL_DEVICE_DOUBLE_FP_CONFIG>()
                                           : device.getInfo<CL_DEVICE_SINGLE_FP_CONFIG>();
    options += fmt::format(" -D HAS_FMA={}", config & CL_FP_FMA ? 1 : 0);
    if (config & CL_FP_CORRECTLY_ROUNDED_DIVIDE_SQRT && !is_double(methods)) {
        options += " -cl-fp32-correctly-rounded-divide-sqrt";
    }
    return options + definitions_of(needs) + options_of(methods);
}

// #region build_program
cl::Program build_program(const cl::Context &context, const std::string &source,
                          const std::string &options, bool from_disk) {
    cl::Program program(context, source);
    try {
        program.build(options.c_str());
    } catch (const cl::BuildError &error) {
        std::string log;
        for (const auto &[device, text] : error.getBuildLog()) {
            log += text.empty() ? "" : ":\n" + text;
        }
        if (from_disk) {
            throw KernelError("the kernel does not build" + log);
        }
        throw DeviceError("the kernel does not build; try another --device (--list-devices)" + log,
                          "the kernel does not build" + first_line_of(log));
    }
    return program;
}
// #endregion build_program

}  // namespace stagelight
