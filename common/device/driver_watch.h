// SPDX-License-Identifier: MIT
// Where an OpenCL driver ends the process, the program starts again.
#pragma once

#include <filesystem>
#include <optional>

namespace stagelight {

// How often this program was started again.
int restarts();

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
