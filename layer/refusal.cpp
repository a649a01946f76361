// SPDX-License-Identifier: MIT
#include "refusal.h"

#include <array>
#include <cstdarg>
#include <cstdio>

namespace stagelight {

void refuse(cl_int code, const char *format, ...) {
    std::array<char, 200> reason{};
    std::va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(reason.data(), reason.size(), format, arguments);
    va_end(arguments);
    throw Refusal{code, reason.data()};
}

void tell(const Refusal &refusal) noexcept {
    if (!refusal.reason.empty()) {
        std::fprintf(stderr, "stagelight_gl_sharing: error %d: %s\n", refusal.code,
                     refusal.reason.c_str());
    }
}

}  // namespace stagelight
