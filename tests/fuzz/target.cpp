// SPDX-License-Identifier: MIT
// libFuzzer's entry points.
#include <csignal>
#include <cstdint>
#include <cstring>
#include <string>

#include <sanitizer/asan_interface.h>
#include <sys/mman.h>
#include <unistd.h>

#include "fuzz/inputs.h"

extern "C" {

// LLVM's SanitizerCoverage counts between them which of our code ran; not in this file, where its
// own declarations of them would clash.
extern char __start___sancov_cntrs[];  // NOLINT: the linker's names
extern char __stop___sancov_cntrs[];   // NOLINT

int LLVMFuzzerInitialize(int *, char ***);
int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size);
void __asan_on_error();  // NOLINT: AddressSanitizer's name
}

namespace {

pid_t fuzzer = 0;

// What run_apart does in a process of its own is to be seen here: the counters' pages, but for the
// first and the last, which hold more than counters, are made common to both.
void share_counters() {
    const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
    const auto start =
        (reinterpret_cast<std::uintptr_t>(__start___sancov_cntrs) + page - 1) & ~(page - 1);
    const auto end = reinterpret_cast<std::uintptr_t>(__stop___sancov_cntrs) & ~(page - 1);
    if (start < end) {
        void *pages = reinterpret_cast<void *>(start);  // NOLINT
        const std::string counters(static_cast<const char *>(pages), end - start);
        mmap(pages, end - start, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS | MAP_FIXED, -1,
             0);
        std::memcpy(pages, counters.data(), counters.size());
    }
}

}  // namespace

int LLVMFuzzerInitialize(int *, char ***) {
    fuzzer = getpid();
    share_counters();
    return 0;
}

// Without an access, what is wrong is a free or the size of an allocation. Apart from the fuzzer
// those are the library's, and a crash there is what run_apart is for.
void __asan_on_error() {
    if (getpid() != fuzzer && __asan_get_report_access_size() == 0) {
        std::raise(SIGKILL);
    }
}

int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
    stagelight::fuzz::FUZZED_INPUT({reinterpret_cast<const char *>(data), size});
    return 0;
}
