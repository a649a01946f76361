// SPDX-License-Identifier: MIT
// Preloaded, makes a call fail: STAGELIGHT_FAULT is its name, and for those that take a file
// ":" and a part of that file's path. Of OpenCL's, STAGELIGHT_FAULT_AFTER as many succeed first.
// STAGELIGHT_ODD_DEVICE is WHAT:NAME: the devices with such a part in their name are GPUs, and have
// WHAT is asked for below.
#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include <CL/cl.h>
#include <dlfcn.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

namespace {

bool is_to_fail(const char *call) {
    const char *fault = std::getenv("STAGELIGHT_FAULT");
    if (fault == nullptr || std::string_view(fault) != call) {
        return false;
    }
    static std::atomic<int> calls = 0;
    const char *after = std::getenv("STAGELIGHT_FAULT_AFTER");
    return ++calls > (after == nullptr ? 0 : std::atoi(after));
}

bool is_to_fail(const char *call, int descriptor) {
    const char *fault = std::getenv("STAGELIGHT_FAULT");
    const std::string start = std::string(call) + ":";
    if (fault == nullptr || !std::string_view(fault).starts_with(start)) {
        return false;
    }
    char path[4096] = "";
    const std::string link = "/proc/self/fd/" + std::to_string(descriptor);
    const ssize_t size = readlink(link.c_str(), path, sizeof path);
    return std::string_view(path, static_cast<std::size_t>(std::max<ssize_t>(size, 0)))
               .find(fault + start.size())
           != std::string_view::npos;
}

template <typename Function> Function *real(Function *, const char *name) {
    return reinterpret_cast<Function *>(dlsym(RTLD_NEXT, name));
}
#define REAL(name) real(&name, #name)

// Whether the device is odd, and in that way; in any where `what` is empty.
bool is_odd(cl_device_id device, std::string_view what) {
    const char *odd = std::getenv("STAGELIGHT_ODD_DEVICE");
    if (odd == nullptr) {
        return false;
    }
    const std::string_view text = odd;
    const std::size_t colon = text.find(':');
    char name[256] = "";
    REAL(clGetDeviceInfo)(device, CL_DEVICE_NAME, sizeof name - 1, name, nullptr);
    return (what.empty() || text.substr(0, colon) == what)
           && std::string_view(name).find(text.substr(colon + 1)) != std::string_view::npos;
}

bool is_odd(cl_program program, std::string_view what) {
    std::vector<cl_device_id> devices(16);
    std::size_t size = 0;
    clGetProgramInfo(program, CL_PROGRAM_DEVICES, devices.size() * sizeof devices[0],
                     devices.data(), &size);
    devices.resize(size / sizeof devices[0]);
    return std::ranges::any_of(devices, [what](cl_device_id d) { return is_odd(d, what); });
}

cl_int answer(const void *bytes, std::size_t length, std::size_t size, void *value,
              std::size_t *size_returned) {
    if (value != nullptr) {
        std::memcpy(value, bytes, std::min(length, size));
    }
    if (size_returned != nullptr) {
        *size_returned = length;
    }
    return CL_SUCCESS;
}

cl_int answer(std::string_view text, std::size_t size, void *value, std::size_t *size_returned) {
    return answer(text.data(), text.size() + 1, size, value, size_returned);
}

}  // namespace

extern "C" {

ssize_t read(int descriptor, void *buffer, std::size_t size) {
    if (is_to_fail("read", descriptor)) {
        errno = EIO;
        return -1;
    }
    return REAL(read)(descriptor, buffer,
                      is_to_fail("short_read", descriptor) ? std::min<std::size_t>(size, 7) : size);
}

// The C library reads by itself. After half of what it was asked for, the disk fails.
std::size_t fread(void *buffer, std::size_t size, std::size_t count, FILE *file) {
    if (is_to_fail("read", fileno(file))) {
        errno = EIO;
        return REAL(fread)(buffer, size, count / 2, file);
    }
    return REAL(fread)(buffer, size, count, file);
}

ssize_t write(int descriptor, const void *bytes, std::size_t size) {
    if (is_to_fail("write", descriptor)) {
        errno = ENOSPC;
        return -1;
    }
    return REAL(write)(descriptor, bytes,
                       is_to_fail("short_write", descriptor) ? std::min<std::size_t>(size, 4099)
                                                             : size);
}

int fsync(int descriptor) {
    if (is_to_fail("fsync", descriptor)) {
        errno = EIO;
        return -1;
    }
    return REAL(fsync)(descriptor);
}

// The disk is full.
int statvfs(const char *path, struct statvfs *disk) noexcept {
    const int code = REAL(statvfs)(path, disk);
    if (is_to_fail("statvfs")) {
        disk->f_bavail = 0;
    }
    return code;
}

int mkdir(const char *path, mode_t mode) noexcept {
    if (is_to_fail(("mkdir:" + std::string(path)).c_str())) {
        errno = EACCES;
        return -1;
    }
    return REAL(mkdir)(path, mode);
}

cl_int clGetDeviceInfo(cl_device_id device, cl_device_info what, std::size_t size, void *value,
                       std::size_t *size_returned) {
    if (what == CL_DEVICE_TYPE && is_odd(device, "")) {
        constexpr cl_device_type type = CL_DEVICE_TYPE_GPU;
        return answer(&type, sizeof type, size, value, size_returned);
    }
    if (what == CL_DEVICE_VERSION && is_odd(device, "opencl_1_1")) {
        return answer("OpenCL 1.1 Mesa 22.3.6", size, value, size_returned);
    }
    if (what == CL_DEVICE_OPENCL_C_VERSION && is_odd(device, "opencl_c_1_1")) {
        return answer("OpenCL C 1.1", size, value, size_returned);
    }
    if (what == CL_DEVICE_IMAGE_SUPPORT && is_odd(device, "no_images")) {
        constexpr cl_bool none = CL_FALSE;
        return answer(&none, sizeof none, size, value, size_returned);
    }
    return REAL(clGetDeviceInfo)(device, what, size, value, size_returned);
}

cl_int clGetProgramBuildInfo(cl_program program, cl_device_id device, cl_program_build_info what,
                             std::size_t size, void *value, std::size_t *size_returned) {
    if (what == CL_PROGRAM_BUILD_LOG && is_odd(device, "no_build")) {
        return answer("ray.cl:7:1: error: an odd compiler\nand more of it", size, value,
                      size_returned);
    }
    return REAL(clGetProgramBuildInfo)(program, device, what, size, value, size_returned);
}

cl_int clGetKernelArgInfo(cl_kernel kernel, cl_uint index, cl_kernel_arg_info what,
                          std::size_t size, void *value, std::size_t *size_returned) {
    return is_to_fail("clGetKernelArgInfo")
               ? CL_KERNEL_ARG_INFO_NOT_AVAILABLE
               : REAL(clGetKernelArgInfo)(kernel, index, what, size, value, size_returned);
}

cl_int clBuildProgram(cl_program program, cl_uint count, const cl_device_id *devices,
                      const char *options, void(CL_CALLBACK *notify)(cl_program, void *),
                      void *data) {
    if (is_to_fail("abort")) {  // as PoCL does
        std::abort();
    }
    if (is_to_fail("exit")) {  // as LLVM does
        std::exit(1);
    }
    return is_to_fail("clBuildProgram") || is_odd(program, "no_build")
               ? CL_BUILD_PROGRAM_FAILURE
               : REAL(clBuildProgram)(program, count, devices, options, notify, data);
}

cl_int clEnqueueNDRangeKernel(cl_command_queue queue, cl_kernel kernel, cl_uint dimensions,
                              const std::size_t *offset, const std::size_t *global,
                              const std::size_t *local, cl_uint count, const cl_event *waits,
                              cl_event *event) {
    return is_to_fail("clEnqueueNDRangeKernel")
               ? CL_OUT_OF_RESOURCES
               : REAL(clEnqueueNDRangeKernel)(queue, kernel, dimensions, offset, global, local,
                                              count, waits, event);
}

cl_int clFinish(cl_command_queue queue) {
    return is_to_fail("clFinish") ? CL_OUT_OF_RESOURCES : REAL(clFinish)(queue);
}

cl_int clEnqueueReadBuffer(cl_command_queue queue, cl_mem buffer, cl_bool blocking,
                           std::size_t offset, std::size_t size, void *data, cl_uint count,
                           const cl_event *waits, cl_event *event) {
    return is_to_fail("clEnqueueReadBuffer")
               ? CL_OUT_OF_RESOURCES
               : REAL(clEnqueueReadBuffer)(queue, buffer, blocking, offset, size, data, count,
                                           waits, event);
}

cl_mem clCreateBuffer(cl_context context, cl_mem_flags flags, std::size_t size, void *data,
                      cl_int *code) {
    if (is_to_fail("clCreateBuffer")) {
        *code = CL_MEM_OBJECT_ALLOCATION_FAILURE;
        return nullptr;
    }
    return REAL(clCreateBuffer)(context, flags, size, data, code);
}

cl_context
clCreateContext(const cl_context_properties *properties, cl_uint count, const cl_device_id *devices,
                void(CL_CALLBACK *notify)(const char *, const void *, std::size_t, void *),
                void *data, cl_int *code) {
    if (is_to_fail("clCreateContext")) {
        *code = CL_DEVICE_NOT_AVAILABLE;
        return nullptr;
    }
    return REAL(clCreateContext)(properties, count, devices, notify, data, code);
}
}
