// SPDX-License-Identifier: MIT
// The folder where PoCL keeps the kernels that it has compiled. PoCL shows no device at all where
// it can't make that folder, and ends the process where the disk is full or a file is damaged.
#pragma once

#include <filesystem>
#include <optional>

namespace stagelight {

// Before the first call into OpenCL. Where PoCL's folder can't be made, or has no room, kernels go
// to a temporary one, which is removed at the end; a warning says so, and why.
void prepare_kernel_cache();

// In the lifetime of one of these, a driver that ends the process (by a signal, or by exit, as
// LLVM does) does not end the program: it starts again, once, with a temporary folder and a
// warning that names the old one. If that ends too, prepare_kernel_cache throws MachineError in
// the program that is started then. Not where the kernels are the user's own, read from a folder:
// they may end the process by themselves. For programs that keep no more than their arguments.
class DriverWatch {
public:
    explicit DriverWatch(const std::optional<std::filesystem::path> &own_kernels);
    ~DriverWatch();
    DriverWatch(const DriverWatch &) = delete;
    DriverWatch &operator=(const DriverWatch &) = delete;
};

// Starts the program again, as above, where it is watched and was not started again before:
// for what shows that the kernels that were kept are no good.
void start_again_if_watched();

}  // namespace stagelight
