// SPDX-License-Identifier: MIT
#include "app/stage_program.h"

#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "app/options.h"
#include "app/run_main.h"
#include "app/show.h"
#include "app/startup.h"
#include "app/stats.h"
#include "budget/budget.h"
#include "device/device_choice.h"
#include "device/kernel_cache.h"
#include "device/renderer.h"
#include "image/image_io.h"
#include "image/whole_file.h"
#include "pov/pov_export.h"
#include "scene/bodies.h"
#include "scene/closed_mesh.h"
#include "scene/errors.h"
#include "scene/progress.h"
#include "scene/radiance_bound.h"
#include "scene/required_features.h"
#include "scene/scene_file.h"
#include "scene/stages.h"

namespace stagelight {
namespace {

void require_outputs(const std::filesystem::path &out, const Options &options) {
    const std::filesystem::path folder = out.parent_path();
    if (std::error_code error;
        !options.out && !exists(folder) && !create_directories(folder, error) && error) {
        throw UserError(fmt::format("{}: the folder {} can't be made: {}; --out names another",
                                    out.string(), folder.string(), error.message()));
    }
    require_writable(out);
    if (options.stats) {
        require_writable_place(*options.stats);
    }
}

RenderSettings settings_of(const Options &options, const Scene &scene, int stage) {
    RenderSettings settings;
    settings.width = options.size ? options.size->first : scene.width;
    settings.height = options.size ? options.size->second : scene.height;
    settings.max_depth = options.depth.value_or(depth_of(scene, stage));
    settings.samples = options.samples;
    settings.methods = options.methods;
    settings.kernels = options.kernels;
    settings.split = options.split;
    return settings;
}

void draw(const std::string &stage, const Options &options, const Scene &scene,
          const RenderSettings &settings, const std::vector<cl::Device> &devices,
          const std::string &reason, Startup &startup) {
    const std::filesystem::path out = options.out.value_or(default_out(stage));
    require_outputs(out, options);

    std::optional<DriverWatch> watch(std::in_place, options.kernels);
    std::optional<Renderer> built;
    const cl::Device device = first_that_builds(devices, [&](const cl::Device &candidate) {
        warn_of_width(candidate, settings.methods);
        built.emplace(candidate, stage, scene, settings);
    });
    Renderer &renderer = *built;
    startup.built(renderer.stage_kernel());
    RunFigures figures;
    figures.display.reason = reason;
    Frame frame;
    const int frames = options.frames.value_or(1);
    std::optional<Progress> progress;
    if (frames > 1) {  // of one, its samples are told
        progress.emplace("rendering frames", frames);
    }
    for (int i = 0; i < frames; ++i) {
        frame = renderer.render();
        if (i == 0) {
            watch.reset();
            startup.done("first_frame");
        }
        figures.frames.push_back(frame.milliseconds);
        if (progress) {
            progress->step();
        }
    }
    progress.reset();
    figures.rays = frame.rays;
    figures.radiance_bound = radiance_bound(scene);
    figures.bytes_on_device = renderer.bytes();

    startup.skip();  // the frames after the first
    write_image(frame.image, out, encode_of(stage_number(stage), options.methods), options.split);
    startup.done("write");
    figures.startup = startup;
    report(stage, device, renderer.stage_kernel(), settings, figures, options);
    fmt::print("wrote {}\n", out.string());
}

int export_scene(const std::string &stage, const Scene &scene, const RenderSettings &settings,
                 const std::filesystem::path &file) {
    const int number = stage_number(stage);
    if (choice(settings.methods, "interior") == "paper") {
        throw UserError("--export-pov: POV-Ray has no --method interior=paper");
    }
    export_pov(scene,
               {.width = settings.width,
                .height = settings.height,
                .max_depth = settings.max_depth,
                .decode = decode_of(number, settings.methods),
                .shows_normals = number == 1},
               file);
    fmt::print("wrote {}\n", file.string());
    return exit_done;
}

// Chooses methods and depth for --max-error, and says which. Of `devices`, the one that they were
// measured on is left. Whether it is met.
bool choose_by_error(const std::string &stage, const Options &options, const Scene &scene,
                     RenderSettings &settings, std::vector<cl::Device> &devices) {
    Budget budget;
    devices = {first_that_builds(devices, [&](const cl::Device &device) {
        budget = meet_budget(device, stage, scene, settings,
                             probe_methods(device, stage, scene, settings), *options.max_error);
    })};
    fmt::print("for --max-error {}: {}\npredicted error {:.2g}, measured {:.2g}\n",
               *options.max_error, to_string(budget.plan, settings.max_depth), budget.plan.error,
               budget.error);
    if (!budget.is_met) {
        fmt::print(stderr, "error: no methods meet --max-error {}; {:.2g} is the best reached\n",
                   *options.max_error, budget.error);
    }
    settings.methods = budget.plan.methods;
    settings.max_depth = budget.plan.max_depth;
    return budget.is_met;
}

std::vector<std::string> warnings_of(const Scene &scene) {
    std::vector<std::string> lines = scene.warnings;
    const auto add = [&lines](const std::vector<std::string> &more) {
        lines.insert(lines.end(), more.begin(), more.end());
    };
    add(open_dielectric_meshes(scene));
    const Bodies bodies = bodies_of(scene);
    add(bodies.warnings);
    bodies_at(scene, bodies, scene.camera.position, &lines);
    return lines;
}

int run(const std::string &stage, const Options &options, Startup &startup) {
    startup.done("start");
    // Before OpenCL's drivers load, which is when they are first asked for: run_sandboxed forks,
    // and a child that is forked beside a loading library would find the loader locked for ever.
    const Scene scene = load_scene(options.scene);
    require_supported(scene, stage_number(stage));
    for (const std::string &line : warnings_of(scene)) {
        warn(line);
    }
    RenderSettings settings = settings_of(options, scene, stage_number(stage));
    if (options.export_pov) {
        return export_scene(stage, scene, settings, *options.export_pov);
    }
    startup.done("scene");
    const bool needs_images = !scene.textures.empty();
    int code = exit_done;
    std::vector<cl::Device> devices;
    if (options.max_error) {
        require_outputs(options.out.value_or(default_out(stage)), options);  // before the wait
        devices = devices_to_try(options.device, needs_images);
        code = choose_by_error(stage, options, scene, settings, devices) ? exit_done
                                                                         : exit_check_failed;
        startup.skip();
    }
    std::string reason = "no window was asked for";
    if (options.display != Display::none) {
        const Shown shown = show(stage, options, scene, settings, startup);
        if (shown.done) {
            return code;
        }
        reason = shown.reason;
        fmt::print("display: none: {}\n", reason);
        startup.done("window");
    }
    if (devices.empty()) {
        devices = devices_to_try(options.device, needs_images);
    }
    draw(stage, options, scene, settings, devices, reason, startup);
    return code;
}

}  // namespace

int run_stage(const std::string &stage, int argc, const char *const *argv) {
    return run_main([&]() -> int {
        Startup startup;
        const std::optional<Options> options = parse_options(stage, argc, argv);
        if (!options) {
            return exit_done;
        }
        if (options->list_devices) {
            fmt::print("{}", list_devices());
            return exit_done;
        }
        return run(stage, *options, startup);
    });
}

}  // namespace stagelight
