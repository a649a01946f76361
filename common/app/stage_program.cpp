// SPDX-License-Identifier: MIT
#include "app/stage_program.h"

#include <fmt/format.h>

#include "app/options.h"
#include "app/run_main.h"
#include "app/stats.h"
#include "device/device_choice.h"
#include "device/renderer.h"
#include "image/image_io.h"
#include "image/whole_file.h"
#include "scene/errors.h"
#include "scene/lessons.h"
#include "scene/scene_file.h"

namespace stagelight {
namespace {

void require_outputs(const Options &options, const std::string &stage) {
    if (options.out == default_out(stage)) {
        std::error_code ignored;  // what is wrong with the folder is told by require_writable
        std::filesystem::create_directories(options.out.parent_path(), ignored);
    }
    require_writable(options.out);
    if (options.stats) {
        require_writable_place(*options.stats);
    }
}

RenderSettings settings_of(const Options &options, const Scene &scene) {
    RenderSettings settings;
    settings.width = options.size ? options.size->first : scene.width;
    settings.height = options.size ? options.size->second : scene.height;
    settings.max_depth = options.depth.value_or(scene.max_depth);
    settings.samples = options.samples;
    settings.methods = options.methods;
    settings.kernels = options.kernels;
    return settings;
}

void report(const Renderer &renderer, const RenderSettings &settings, double milliseconds,
            const RayTotals &rays, const std::filesystem::path &out) {
    const double total =
        static_cast<double>(rays.primary + rays.shadow + rays.reflection + rays.refraction);
    fmt::print("{}\n", renderer.device().getInfo<CL_DEVICE_NAME>());
    fmt::print("{}x{}: {:.1f} ms, {:.2f} million rays/s (kernel built in {:.0f} ms)\n",
               settings.width, settings.height, milliseconds, total / milliseconds / 1000,
               renderer.build_milliseconds());
    if (rays.dropped > 0) {
        fmt::print("{} rays dropped: deeper than {} bounces (--depth)\n", rays.dropped,
                   settings.max_depth);
    }
    fmt::print("wrote {}\n", out.string());
}

int render(const std::string &stage, const Options &options) {
    const Scene scene = load_scene(options.scene);
    require_learnt(scene, stage_number(stage));
    const cl::Device device = choose_device(options.device);
    require_outputs(options, stage);

    const RenderSettings settings = settings_of(options, scene);
    Renderer renderer(device, stage, scene, settings);
    std::vector<double> frames;
    Frame frame;
    for (int i = 0; i < options.frames; ++i) {
        frame = renderer.render();
        frames.push_back(frame.milliseconds);
    }

    write_image(frame.image, options.out, encode_of(stage_number(stage), options.methods));
    if (options.stats) {
        const std::string json = stats_json(stage, renderer, settings, frames, frame);
        write_whole(std::vector<unsigned char>(json.begin(), json.end()), *options.stats);
    }
    report(renderer, settings, median(frames), frame.rays, options.out);
    return exit_done;
}

}  // namespace

int run_stage(const std::string &stage, int argc, const char *const *argv) {
    return run_main([&]() -> int {
        const std::optional<Options> options = parse_options(stage, argc, argv);
        if (!options) {
            return exit_done;
        }
        if (options->list_devices) {
            fmt::print("{}", list_devices());
            return exit_done;
        }
        return render(stage, *options);
    });
}

}  // namespace stagelight
