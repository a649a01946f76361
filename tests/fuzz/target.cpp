// SPDX-License-Identifier: MIT
// libFuzzer's entry points.
#include <algorithm>
#include <cstdint>

#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "fuzz/inputs.h"

extern "C" {

// LLVM's SanitizerCoverage counts between them which of our code ran; not in this file, where its
// own declarations of them would clash.
extern unsigned char __start___sancov_cntrs[];  // NOLINT: the linker's names
extern unsigned char __stop___sancov_cntrs[];   // NOLINT

int LLVMFuzzerInitialize(int *, char ***);
int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size);
}

namespace {

pid_t fuzzer = 0;
unsigned char *counted_in_sandbox = nullptr;  // in memory that is common to all

void take_larger(const unsigned char *from, const unsigned char *end, unsigned char *to) {
    std::transform(from, end, to, to, [](auto a, auto b) { return std::max(a, b); });
}

}  // namespace

int LLVMFuzzerInitialize(int *, char ***) {
    fuzzer = getpid();
    const auto size = static_cast<std::size_t>(__stop___sancov_cntrs - __start___sancov_cntrs);
    counted_in_sandbox = static_cast<unsigned char *>(
        mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0));
    return counted_in_sandbox == MAP_FAILED ? 1 : 0;
}

// The end of what run_sandboxed does in a process of its own: what ran there is to be seen here.
void _exit(int code) {
    if (getpid() != fuzzer) {
        take_larger(__start___sancov_cntrs, __stop___sancov_cntrs, counted_in_sandbox);
    }
    syscall(SYS_exit_group, code);
    __builtin_unreachable();
}

int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
    stagelight::fuzz::FUZZED_INPUT({reinterpret_cast<const char *>(data), size});
    const auto counters = __stop___sancov_cntrs - __start___sancov_cntrs;
    take_larger(counted_in_sandbox, counted_in_sandbox + counters, __start___sancov_cntrs);
    std::fill_n(counted_in_sandbox, counters, static_cast<unsigned char>(0));
    return 0;
}
