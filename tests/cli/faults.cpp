// SPDX-License-Identifier: MIT
// Preloaded, makes a call fail: STAGELIGHT_FAULT is its name, and for those that take a file
// ":" and a part of that file's path. Of OpenCL's, STAGELIGHT_FAULT_AFTER as many succeed first.
#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include <CL/cl.h>
#include <dlfcn.h>
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

cl_int clBuildProgram(cl_program program, cl_uint count, const cl_device_id *devices,
                      const char *options, void(CL_CALLBACK *notify)(cl_program, void *),
                      void *data) {
    return is_to_fail("clBuildProgram")
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
