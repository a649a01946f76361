// SPDX-License-Identifier: MIT
#include "kernels.h"

#include <cstring>

#include "driver.h"
#include "layer.h"

namespace stagelight {
namespace {

void remember(cl_kernel kernel, const KernelRecord &record = {}) {
    kernels.add(kernel, std::make_shared<KernelRecord>(record));
}

cl_kernel CL_API_CALL create_kernel(cl_program program, const char *name, cl_int *errcode_ret) {
    return answer_handle(errcode_ret, [&] {
        const cl_kernel kernel = made_by(driver->clCreateKernel, program, name);
        remember(kernel);
        return kernel;
    });
}

cl_int CL_API_CALL create_kernels(cl_program program, cl_uint room, cl_kernel *made,
                                  cl_uint *count_ret) {
    return answer([&] {
        cl_uint count = 0;
        require(driver->clCreateKernelsInProgram(program, room, made, &count));
        for (cl_uint i = 0; made != nullptr && i < count; ++i) {
            remember(made[i]);
        }
        if (count_ret != nullptr) {
            *count_ret = count;
        }
    });
}

cl_kernel CL_API_CALL clone_kernel(cl_kernel from, cl_int *errcode_ret) {
    return answer_handle(errcode_ret, [&] {
        const cl_kernel kernel = made_by(driver->clCloneKernel, from);
        const auto record = kernels.find(from);
        remember(kernel, record == nullptr ? KernelRecord{} : *record);
        return kernel;
    });
}

cl_int CL_API_CALL set_argument(cl_kernel kernel, cl_uint index, std::size_t size,
                                const void *value) {
    return answer([&] {
        require(driver->clSetKernelArg(kernel, index, size, value));
        const auto record = kernels.find(kernel);
        cl_mem handle = nullptr;
        if (value != nullptr && size == sizeof(handle)) {
            std::memcpy(&handle, value, size);
        }
        const auto object = objects.find(handle);
        if (record != nullptr && object != nullptr) {
            record->arguments[index] = object;
        } else if (record != nullptr) {
            record->arguments.erase(index);
        }
    });
}

cl_int CL_API_CALL retain_kernel(cl_kernel kernel) {
    const cl_int code = driver->clRetainKernel(kernel);
    if (code == CL_SUCCESS) {
        kernels.retain(kernel);
    }
    return code;
}

cl_int CL_API_CALL release_kernel(cl_kernel kernel) {
    kernels.release(kernel);
    return driver->clReleaseKernel(kernel);
}

}  // namespace

void install_kernels(cl_icd_dispatch &table) {
    table.clCreateKernel = create_kernel;
    table.clCreateKernelsInProgram = create_kernels;
    table.clCloneKernel = clone_kernel;
    table.clSetKernelArg = set_argument;
    table.clRetainKernel = retain_kernel;
    table.clReleaseKernel = release_kernel;
}

}  // namespace stagelight
