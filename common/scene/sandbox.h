// SPDX-License-Identifier: MIT
// Libraries that read files from elsewhere crash, hang and leak on some: here they do it in a child
// process.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace stagelight {

// The bytes that `work` returns, which runs in a process of its own, with at most half of the
// machine's memory, and time, of the CPU and by the clock, that goes by the size of the file it
// reads. UserErrors and std::bad_alloc come back from there; if it crashes or takes longer, that is
// a UserError about `what`, "where: file", which says what was `expected`. What else it does is
// lost with it. Nothing that it prints is seen.
std::string run_sandboxed(const std::string &what, std::uintmax_t file_size,
                          const std::function<std::string()> &work,
                          const std::string &expected = "an undamaged file");

// Called from there when the library has done its part: the rest may take its time.
void allow_any_time();

}  // namespace stagelight
