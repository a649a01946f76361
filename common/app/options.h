// SPDX-License-Identifier: MIT
// The command line that every stage's program has, read with CLI11.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "device/methods.h"

namespace stagelight {

struct Options {
    std::filesystem::path scene;
    std::optional<std::pair<int, int>> size;  // pixels; else the scene's
    std::filesystem::path out;
    int samples = 1;
    std::optional<int> depth;  // bounces; else the scene's
    std::string device;
    int frames = 1;
    Methods methods;
    std::optional<std::filesystem::path> kernels;
    std::optional<std::filesystem::path> stats;
    bool list_devices = false;
};

// out/STAGE.png, below the current folder.
std::filesystem::path default_out(const std::string &stage);

// `stage` is its folder's name: it gives the default scene and output. Prints the help and
// returns nothing when that was asked for. Throws UserError.
std::optional<Options> parse_options(const std::string &stage, int argc, const char *const *argv);

}  // namespace stagelight
