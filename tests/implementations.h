// SPDX-License-Identifier: MIT
// The OpenCL implementations that tests run on: the two that packages/ brings, which share Clang
// and LLVM and nothing else, or the one that STAGELIGHT_DEVICE names (./stagelight test --device),
// where programs that tests start draw too.
#pragma once

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <string>
#include <vector>

namespace stagelight {

inline const char *const asked_device = std::getenv("STAGELIGHT_DEVICE");

// Rusticl must be asked for before the first call into OpenCL. Who names a device may have it drive
// another than Mesa's llvmpipe.
inline const bool rusticl_enabled =
    setenv("RUSTICL_ENABLE", "llvmpipe", asked_device == nullptr) == 0;

// By parts of what --list-devices says: PoCL's version, and rusticl's device on Mesa's llvmpipe.
inline const std::vector<const char *> implementations =
    asked_device != nullptr ? std::vector{asked_device} : std::vector{"pocl", "llvmpipe"};

inline bool is_rusticl(const std::string &device) {
    return device.find("llvmpipe") != std::string::npos;
}

// As a part of a test's name, which has letters and digits alone.
inline std::string name_in_tests(std::string device) {
    std::ranges::replace_if(
        device, [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
    return device;
}

}  // namespace stagelight
