// SPDX-License-Identifier: MIT
#include "app/show.h"

#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "app/stats.h"
#include "device/device_choice.h"
#include "device/kernel_cache.h"
#include "display/gl_sharing.h"
#include "display/viewer.h"
#include "image/image_io.h"
#include "scene/errors.h"
#include "scene/radiance_bound.h"
#include "scene/stages.h"

namespace stagelight {
namespace {

std::vector<cl::Device> devices_for(const Window &window, const Options &options,
                                    const Scene &scene) {
    const bool needs_images = !scene.textures.empty();
    return options.display == Display::shared
               ? devices_to_share(options.device, window.api(), needs_images)
               : devices_to_try(options.device, needs_images);
}

WindowSettings window_of(const std::string &stage, const Options &options,
                         const RenderSettings &settings) {
    constexpr double largest = 16384;  // each way, as X servers and drivers take it
    const auto pixels = [&](int length) {
        if (length * options.scale > largest) {
            throw UserError(fmt::format(
                "--scale {}: the window would be {:.0f}x{:.0f} pixels, expected {:.0f} at most "
                "each way",
                options.scale, settings.width * options.scale, settings.height * options.scale,
                largest));
        }
        return static_cast<int>(std::lround(length * options.scale));
    };
    return {.width = pixels(settings.width),
            .height = pixels(settings.height),
            .title = stage,
            .api = ContextApi::native,
            .vsync = !options.frames};  // what is timed waits for no screen
}

ViewSettings view_of(const std::string &stage, const Options &options) {
    ViewSettings view;
    view.scale = options.scale;
    view.frames = options.frames;
    view.encode = encode_of(stage_number(stage), options.methods);
    view.split = options.split;
    view.screenshots = options.out.value_or(default_out(stage));
    view.checkout = options.kernels.value_or(STAGELIGHT_CHECKOUT);
    return view;
}

std::deque<DisplayPath> paths_of(Display display) {
    return display == Display::shared ? std::deque{DisplayPath::shared, DisplayPath::copy}
                                      : std::deque{DisplayPath::copy};
}

RunFigures figures_of(const Window &window, const FramePipeline &pipeline, const ViewFigures &seen,
                      const Scene &scene, const Startup &startup) {
    RunFigures figures;
    for (const FrameTimes &frame : seen.frames) {
        figures.frames.push_back(frame.milliseconds);
    }
    figures.rays = seen.rays;
    figures.radiance_bound = radiance_bound(scene);
    figures.bytes_on_device = pipeline.bytes();
    figures.startup = startup;
    figures.display = {.path = to_string(pipeline.path()),
                       .reason = pipeline.reason(),
                       .api = window.api() == ContextApi::egl ? "egl" : "glx",
                       .color_bits = window.color_bits(),
                       .width = window.framebuffer_size().x,
                       .height = window.framebuffer_size().y,
                       .frames = seen.frames};
    return figures;
}

void show_in(Window &window, const std::string &stage, const Options &options, const Scene &scene,
             const RenderSettings &settings, Startup &startup) {
    std::optional<FramePipeline> built;
    {
        const DriverWatch watch(options.kernels);
        first_that_builds(devices_for(window, options, scene), [&](const cl::Device &device) {
            warn_of_width(device, settings.methods);
            built.emplace(device, window.api(), stage, scene, settings, paths_of(options.display),
                          options.texture_format);
        });
    }
    FramePipeline &pipeline = *built;
    startup.built(pipeline.stage_kernel());
    Viewer viewer(window, pipeline, stage, scene, view_of(stage, options));
    const ViewFigures seen = viewer.run();
    if (options.out) {
        write_image(seen.picture, *options.out, encode_of(stage_number(stage), options.methods),
                    options.split);
    }
    if (!seen.frames.empty()) {
        startup.done("first_frame", seen.first_shown);
        report(stage, pipeline.device(), pipeline.stage_kernel(), pipeline.settings(),
               figures_of(window, pipeline, seen, scene, startup), options);
    }
    if (options.out) {
        fmt::print("wrote {}\n", options.out->string());
    }
}

}  // namespace

Shown show(const std::string &stage, const Options &options, const Scene &scene,
           const RenderSettings &settings, Startup &startup) {
    std::optional<Window> window;
    try {
        window.emplace(window_of(stage, options, settings));
    } catch (const MachineError &error) {
        if (options.window) {
            throw;
        }
        return {false, error.what()};
    }
    startup.done("window");
    try {
        show_in(*window, stage, options, scene, settings, startup);
        return {true, ""};
    } catch (const PresenterLost &lost) {
        if (options.window) {
            throw MachineError(
                fmt::format("{}; --display none writes a picture file", lost.what()));
        }
        return {false, lost.what()};
    }
}

}  // namespace stagelight
