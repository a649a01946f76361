// SPDX-License-Identifier: MIT
#include "app/draw.h"

#include <optional>
#include <utility>

#include "device/driver_watch.h"
#include "device/renderer.h"
#include "scene/progress.h"

namespace stagelight {

RunResult draw(Run &run, const std::string &reason) {
    std::optional<DriverWatch> watch(std::in_place, run.options.kernels);
    Renderer renderer = drawer_on_first(run.devices, run, [&](const cl::Device &device) {
        return Renderer(device, run.stage, run.scene, run.settings);
    });
    std::vector<double> milliseconds;
    Frame frame;
    const int frames = run.options.frames.value_or(1);
    std::optional<Progress> progress;
    if (frames > 1) {  // of one, its samples are told
        progress.emplace("rendering frames", frames);
    }
    for (int i = 0; i < frames; ++i) {
        frame = renderer.render();
        if (i == 0) {
            watch.reset();
            run.startup.done("first_frame");
        }
        milliseconds.push_back(frame.milliseconds);
        if (progress) {
            progress->step();
        }
    }
    RunResult result = result_of(renderer);
    result.frames = std::move(milliseconds);
    result.rays = frame.rays;
    result.picture = std::move(frame.image);
    result.file = run.options.out.value_or(default_out(run.stage));
    result.display.reason = reason;
    return result;
}

}  // namespace stagelight
