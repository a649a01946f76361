#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""vectors_test.py PAGE: the examples of docs/opencl-vectors.md have the values that stand behind them, on every
OpenCL device of this machine.

A line that ends with ; is put into a kernel as it is. Any other is an expression, with its value behind //."""
import ctypes
import re
import sys

CL_DEVICE_TYPE_ALL, CL_DEVICE_NAME = 0xFFFFFFFF, 0x102B
CL_PROGRAM_BUILD_LOG = 0x1183
CL_MEM_COPY_HOST_PTR = 1 << 5
WIDEST = 16  # of a vector
TOLERANCE = 1e-6

cl = ctypes.CDLL("libOpenCL.so.1")
for name in ("clCreateContext", "clCreateCommandQueue", "clCreateProgramWithSource", "clCreateKernel",
             "clCreateBuffer"):
    getattr(cl, name).restype = ctypes.c_void_p


def examples(page):
    """Lines of a kernel, and (line in the page, expression, its values) of those that are to be checked."""
    body, checks, inside = [], [], False
    for number, line in enumerate(open(page, encoding="utf-8"), 1):
        line = line.strip()
        if line.startswith("```"):
            inside = line == "```c"
        elif inside and line.endswith(";"):
            body.append(line)
        elif inside:
            expression, values = re.fullmatch(r"(.*?)\s*// (.*)", line).groups()
            values = [float(value) for value in values.split()]
            place = WIDEST * len(checks)
            store = (f"out[{place}] = {expression};" if len(values) == 1
                     else f"vstore{len(values)}(convert_float{len(values)}({expression}), 0, out + {place});")
            body.append(store)
            checks.append((number, expression, values))
    return body, checks


def devices():
    count = ctypes.c_uint()
    cl.clGetPlatformIDs(0, None, ctypes.byref(count))
    platforms = (ctypes.c_void_p * count.value)()
    cl.clGetPlatformIDs(count, platforms, None)
    for platform in platforms:
        found = (ctypes.c_void_p * 16)()
        count.value = 0
        cl.clGetDeviceIDs(ctypes.c_void_p(platform), ctypes.c_ulong(CL_DEVICE_TYPE_ALL), 16, found, ctypes.byref(count))
        yield from (ctypes.c_void_p(device) for device in found[:count.value])


def name_of(device):
    name = ctypes.create_string_buffer(256)
    cl.clGetDeviceInfo(device, CL_DEVICE_NAME, ctypes.c_size_t(256), name, None)
    return name.value.decode()


def checked(status, what):
    if status:
        sys.exit(f"{what} failed with error {status}")


def run(device, body, count):
    """What the kernel wrote."""
    status = ctypes.c_int()

    def made(create, *arguments):
        handle = ctypes.c_void_p(create(*arguments, ctypes.byref(status)))
        checked(status.value, create.__name__)
        return handle

    context = made(cl.clCreateContext, None, 1, ctypes.byref(device), None, None)
    queue = made(cl.clCreateCommandQueue, context, device, ctypes.c_ulong(0))
    lines = "\n".join(body)
    source = f"__kernel void examples(__global float *out, __global const float *numbers) {{\n{lines}\n}}\n".encode()
    text = ctypes.c_char_p(source)
    program = made(cl.clCreateProgramWithSource, context, 1, ctypes.byref(text), None)
    if cl.clBuildProgram(program, 1, ctypes.byref(device), b"-cl-std=CL1.2", None, None):
        log = ctypes.create_string_buffer(1 << 16)
        cl.clGetProgramBuildInfo(program, device, CL_PROGRAM_BUILD_LOG, ctypes.c_size_t(len(log)), log, None)
        sys.exit(f"{name_of(device)}: {log.value.decode()}\n{source.decode()}")
    kernel = made(cl.clCreateKernel, program, b"examples")
    numbers = (ctypes.c_float * 32)(*range(32))
    out = (ctypes.c_float * (WIDEST * count))()
    buffers = [made(cl.clCreateBuffer, context, ctypes.c_ulong(CL_MEM_COPY_HOST_PTR),
                    ctypes.c_size_t(ctypes.sizeof(memory)), memory) for memory in (out, numbers)]
    for index, buffer in enumerate(buffers):
        checked(cl.clSetKernelArg(kernel, index, ctypes.c_size_t(ctypes.sizeof(buffer)), ctypes.byref(buffer)),
                "clSetKernelArg")
    one = ctypes.c_size_t(1)
    checked(cl.clEnqueueNDRangeKernel(queue, kernel, 1, None, ctypes.byref(one), None, 0, None, None),
            "clEnqueueNDRangeKernel")
    size = ctypes.c_size_t(ctypes.sizeof(out))
    checked(cl.clEnqueueReadBuffer(queue, buffers[0], 1, ctypes.c_size_t(0), size, out, 0, None, None),
            "clEnqueueReadBuffer")
    return out


def main():
    body, checks = examples(sys.argv[1])
    wrong, tried = 0, 0
    for device in devices():
        tried += 1
        out = run(device, body, len(checks))
        for index, (number, expression, expected) in enumerate(checks):
            seen = list(out[WIDEST * index:WIDEST * index + len(expected)])
            if not all(abs(a - b) <= TOLERANCE for a, b in zip(seen, expected)):
                print(f"{sys.argv[1]}:{number}: on {name_of(device)} {expression} is {seen}, not {expected}")
                wrong += 1
    if not tried or not checks:
        sys.exit("no OpenCL device, or no example")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
