// SPDX-License-Identifier: MIT
// The command line that every stage's program has, read with CLI11.
#pragma once

#include <deque>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "device/methods.h"
#include "display/frame_pipeline.h"

namespace stagelight {

struct Options {
    std::filesystem::path scene;
    std::optional<std::pair<int, int>> size;   // pixels; else the scene's
    std::optional<std::filesystem::path> out;  // else default_out, when there is no window
    int samples = 1;
    std::optional<int> depth;  // bounces; else the scene's
    std::string device;
    std::optional<int> frames;        // else one picture, and a window until it is closed
    bool window = false;              // one is demanded
    std::deque<DisplayPath> display;  // to try in order; else, and after them, a picture file
    TextureFormat texture_format = TextureFormat::rgba32f;
    bool split = false;  // figure 4 of the paper
    double scale = 1;    // the window's pixels for one of the picture's, each way
    Methods methods;
    std::optional<double> max_error;  // RMSE in linear light: methods are chosen by it
    std::optional<std::filesystem::path> kernels;
    std::optional<std::filesystem::path> stats;
    std::optional<std::filesystem::path> export_pov;
    bool list_devices = false;
    bool verbose = false;
    bool quiet = false;  // no warnings
};

// out/STAGE.png, below the current folder.
std::filesystem::path default_out(const std::string &stage);

// `stage` is its folder's name: it gives the default scene and output. Prints the help, the version
// or the methods and returns nothing when that was asked for. Throws UserError.
std::optional<Options> parse_options(const std::string &stage, int argc, const char *const *argv);

}  // namespace stagelight
