// SPDX-License-Identifier: MIT
// What AddressSanitizer finds in a process of run_sandboxed's that is the library's mistake.
#ifdef __SANITIZE_ADDRESS__
#define HAS_ADDRESS_SANITIZER
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define HAS_ADDRESS_SANITIZER
#endif
#endif

#ifdef HAS_ADDRESS_SANITIZER
#include <csignal>

#include <sanitizer/asan_interface.h>
#include <unistd.h>

namespace {

const pid_t first_process = getpid();

}  // namespace

// Without an access, what is wrong is a free or the size of an allocation. In a sandbox
// those are the library's, and a crash there is what run_sandboxed is for.
extern "C" void __asan_on_error();  // NOLINT: AddressSanitizer's name
void __asan_on_error() {
    if (getpid() != first_process && __asan_get_report_access_size() == 0) {
        std::raise(SIGKILL);
    }
}
#endif
