// SPDX-License-Identifier: MIT
#include "app/show.h"

#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "device/driver_watch.h"
#include "display/gl_sharing.h"
#include "scene/errors.h"
#include "scene/stages.h"

namespace stagelight {
namespace {

std::vector<cl::Device> devices_for(const Window &window, const Run &run) {
    const bool needs_images = !run.scene.textures.empty();
    return run.options.display.front() == DisplayPath::shared
               ? devices_to_share(run.options.device, window.api(), needs_images)
               : devices_to_try(run.options.device, needs_images);
}

WindowSettings window_of(const Run &run) {
    constexpr double largest = 16384;  // each way, as X servers and drivers take it
    const RenderSettings &settings = run.settings;
    const double scale = run.options.scale;
    const auto pixels = [&](int length) {
        if (length * scale > largest) {
            throw UserError(fmt::format(
                "--scale {}: the window would be {:.0f}x{:.0f} pixels, expected {:.0f} at most "
                "each way",
                scale, settings.width * scale, settings.height * scale, largest));
        }
        return static_cast<int>(std::lround(length * scale));
    };
    return {.width = pixels(settings.width),
            .height = pixels(settings.height),
            .title = run.stage,
            .api = ContextApi::native,
            .vsync = !run.options.frames};  // what is timed waits for no screen
}

// A window that nobody demanded gives way to a picture file.
void open(std::optional<Window> &window, const Run &run) {
    try {
        window.emplace(window_of(run));
    } catch (const MachineError &error) {
        if (run.options.window) {
            throw;
        }
        throw PresenterLost(error.what());
    }
}

ViewSettings view_of(const Run &run) {
    ViewSettings view;
    view.scale = run.options.scale;
    view.frames = run.options.frames;
    view.encode = encode_of(stage_number(run.stage), run.settings.methods);
    view.split = run.options.split;
    view.screenshots = run.options.out.value_or(default_out(run.stage));
    view.checkout = run.options.kernels.value_or(STAGELIGHT_CHECKOUT);
    return view;
}

}  // namespace

RunResult show(Run &run) {
    std::optional<Window> window;
    open(window, run);
    run.startup.done("window");
    run.settings.eye_moves = !run.options.frames;
    std::optional<DriverWatch> watch(std::in_place, run.options.kernels);
    FramePipeline pipeline =
        drawer_on_first(devices_for(*window, run), run, [&](const cl::Device &device) {
            return FramePipeline(device, window->api(), run.stage, run.scene, run.settings,
                                 run.options.display, run.options.texture_format);
        });
    watch.reset();
    ViewFigures seen = Viewer(*window, pipeline, run.stage, run.scene, view_of(run)).run();
    if (!seen.frames.empty()) {
        run.startup.done("first_frame", seen.first_shown);
    }
    RunResult result = result_of(pipeline);
    for (const FrameTimes &frame : seen.frames) {
        result.frames.push_back(frame.milliseconds);
    }
    result.rays = seen.rays;
    result.picture = std::move(seen.picture);
    result.file = run.options.out;
    result.display = {.path = to_string(pipeline.path()),
                      .reason = pipeline.reason(),
                      .api = window->api() == ContextApi::egl ? "egl" : "glx",
                      .color_bits = window->color_bits(),
                      .width = window->framebuffer_size().x,
                      .height = window->framebuffer_size().y,
                      .frames = std::move(seen.frames)};
    return result;
}

}  // namespace stagelight
