// SPDX-License-Identifier: MIT
// What each method does to a scene on a device: measured on a small picture, kept for the next
// time.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "device/renderer.h"
#include "scene/scene.h"

namespace stagelight {

// A choice that is not the base's: a method, or another depth limit (kind "limit").
struct Probe {
    std::string kind;
    std::string name;
    double ratio = 1;  // its milliseconds over the base's, the median of rounds in turn
    double error = 0;  // RMSE against the base's picture
};

struct Probes {
    Methods base;           // the most accurate methods in float
    double base_error = 0;  // RMSE of their picture against truth_of
    std::vector<Probe> probes;
    std::optional<Probe> in_double = {};  // the base in double, where the device has that: its
                                          // error is against truth_of, too
};

// How many times as long one takes to draw as the other, the median of `pairs` in turn: what slows
// the machine down for a while slows both. Neither's first picture, which builds the kernel, is to
// be among them.
double time_ratio(Renderer &one, Renderer &other, int pairs);

// Whether methods of that kind trade error for time: the others change how many rays run side by
// side, or what a file's values mean.
bool is_approximate(const std::string &kind);

// The depth limits below one that it may be worth to try.
std::vector<int> limits_below(int max_depth);

// Of every method that matters to the scene, but those of kinds that `settings` choose themselves.
// Reads and writes the file of this scene, device and program below the user's cache folder; where
// that can't be written they are measured anew each time.
Probes probe_methods(const cl::Device &device, const std::string &stage, const Scene &scene,
                     const RenderSettings &settings);

}  // namespace stagelight
