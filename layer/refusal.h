// SPDX-License-Identifier: MIT
// How a call is refused: inside the layer by an exception, which never leaves it.
#pragma once

#include <new>
#include <string>

#include <CL/cl.h>

namespace stagelight {

struct Refusal {
    cl_int code;         // what the program gets
    std::string reason;  // what its author reads; empty when the driver refused
};

// Throws a driver's error on.
inline void require(cl_int code) {
    if (code != CL_SUCCESS) {
        throw Refusal{code, {}};
    }
}

inline void require(bool holds, cl_int code, const char *reason) {
    if (!holds) {
        throw Refusal{code, reason};
    }
}

// Throws Refusal with a reason as printf would write it.
[[noreturn, gnu::format(printf, 2, 3)]] void refuse(cl_int code, const char *format, ...);

// Writes the reason to stderr: OpenCL's codes alone say too little to those who learn.
void tell(const Refusal &refusal) noexcept;

// Runs `call` and gives the code for the program: all that C may see of an exception.
template <typename Call> cl_int answer(Call call) noexcept {
    try {
        call();
        return CL_SUCCESS;
    } catch (const Refusal &refusal) {
        tell(refusal);
        return refusal.code;
    } catch (const std::bad_alloc &) {
        return CL_OUT_OF_HOST_MEMORY;
    }
}

// The same for the functions that give a handle and take a pointer for the code.
template <typename Call> auto answer_handle(cl_int *errcode_ret, Call call) noexcept {
    decltype(call()) handle = nullptr;
    const cl_int code = answer([&] { handle = call(); });
    if (errcode_ret != nullptr) {
        *errcode_ret = code;
    }
    return handle;
}

}  // namespace stagelight
