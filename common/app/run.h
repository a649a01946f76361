// SPDX-License-Identifier: MIT
// What the parts of a stage's program hand on to each other: the command line, the scene, what
// draws it, and what that made of it.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/options.h"
#include "app/startup.h"
#include "device/device_choice.h"
#include "device/stage_kernel.h"
#include "device/texture_fit.h"
#include "display/viewer.h"
#include "image/image.h"
#include "scene/progress.h"
#include "scene/scene.h"
#include "scene/stages.h"

namespace stagelight {

struct Run {
    std::string stage;  // its folder's name
    Startup startup{};
    Options options{};
    Scene scene{};
    RenderSettings settings{};
    std::vector<cl::Device> devices{};  // that a picture file is drawn on, the first that can
};

struct DisplayFigures {
    std::string path = "none";
    std::string reason;  // why that one, and none before it
    // Of a window alone:
    std::string api;     // glx or egl
    int color_bits = 0;  // a channel of its framebuffer
    int width = 0;       // of its framebuffer, pixels
    int height = 0;      // of its framebuffer, pixels
    std::vector<FrameTimes> frames;
};

// What is known when the last frame is done.
struct RunResult {
    cl::Device device{};
    RenderSettings settings{};  // of the last picture
    SceneNeeds needs{};
    std::string build_options{};
    double build_milliseconds = 0;  // of the kernel
    std::map<std::string, std::size_t> bytes_on_device{};
    std::vector<double> frames{};                 // milliseconds each
    RayTotals rays{};                             // of the last
    Image picture{};                              // the last
    std::optional<std::filesystem::path> file{};  // to write it to
    DisplayFigures display{};
};

// So that the device takes the scene's textures.
inline void fit_textures(Run &run, const cl::Device &device) {
    const Transfer decode = decode_of(stage_number(run.stage), run.settings.methods);
    warn(fit_textures(run.scene, texture_limits(device), decode));
}

// What draws, a Renderer or a FramePipeline: `make` makes it of the first of the devices that
// builds its kernel.
auto drawer_on_first(const std::vector<cl::Device> &devices, Run &run, const auto &make) {
    std::optional<decltype(make(devices.front()))> drawer;
    first_that_builds(devices, [&](const cl::Device &device) {
        warn_of_width(device, run.settings.methods);
        fit_textures(run, device);
        drawer.emplace(make(device));
    });
    run.startup.built(drawer->stage_kernel());
    return *std::move(drawer);
}

// What is known of that.
RunResult result_of(const auto &drawer) {
    const StageKernel &kernel = drawer.stage_kernel();
    return {.device = drawer.device(),
            .settings = drawer.settings(),
            .needs = kernel.needs(),
            .build_options = kernel.options(),
            .build_milliseconds = kernel.milliseconds().kernel,
            .bytes_on_device = drawer.bytes()};
}

}  // namespace stagelight
