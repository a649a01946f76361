// SPDX-License-Identifier: MIT
// What a run has cost, as JSON.
#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "app/options.h"
#include "app/startup.h"
#include "device/stage_kernel.h"
#include "display/viewer.h"

namespace stagelight {

struct DisplayFigures {
    std::string path = "none";
    std::string reason;  // why that one, and none above it
    // Of a window alone:
    std::string api;     // glx or egl
    int color_bits = 0;  // a channel of its framebuffer
    int width = 0;       // of its framebuffer, pixels
    int height = 0;      // of its framebuffer, pixels
    std::vector<FrameTimes> frames;
};

// What is known when the last frame is done.
struct RunFigures {
    std::vector<double> frames;  // milliseconds each
    RayTotals rays;              // of the last
    double radiance_bound = 0;   // of the scene (scene/radiance_bound.h)
    std::map<std::string, std::size_t> bytes_on_device;
    DisplayFigures display;
    Startup startup;
};

// Its name, platform, versions and compute units.
nlohmann::ordered_json device_json(const cl::Device &device);
// By kind.
nlohmann::ordered_json rays_json(const RayTotals &rays);
// By argument, and their total.
nlohmann::ordered_json bytes_json(const std::map<std::string, std::size_t> &sizes);

// Device, driver, build options, milliseconds a frame and from start to picture, rays by kind,
// dropped rays, bytes on the device, what the scene needed and what was disabled, and how the
// frames came to the window.
std::string stats_json(const std::string &stage, const cl::Device &device,
                       const StageKernel &kernel, const RenderSettings &settings,
                       const RunFigures &figures);

// Says on stdout which device has drawn and what that cost, and with --verbose where the time went,
// what was cut off and what the kernel leaves out; writes the stats if --stats names a file.
void report(const std::string &stage, const cl::Device &device, const StageKernel &kernel,
            const RenderSettings &settings, const RunFigures &figures, const Options &options);

// Of the time in which frames were presented, the share in which the next was being rendered.
double overlap_of(const std::vector<FrameTimes> &frames);

// The middle one; the mean of the middle two.
double median(std::vector<double> values);

// That of what `figure` says of each element.
double median_of(const auto &elements, const auto &figure) {
    std::vector<double> values(elements.size());
    std::ranges::transform(elements, values.begin(), figure);
    return median(std::move(values));
}

}  // namespace stagelight
