// SPDX-License-Identifier: MIT
#include "app/stage_program.h"

#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "app/draw.h"
#include "app/run_main.h"
#include "app/show.h"
#include "app/stats.h"
#include "budget/budget.h"
#include "image/image_io.h"
#include "image/whole_file.h"
#include "pov/pov_export.h"
#include "scene/bodies.h"
#include "scene/closed_mesh.h"
#include "scene/errors.h"
#include "scene/progress.h"
#include "scene/required_features.h"
#include "scene/scene_file.h"
#include "scene/stages.h"

namespace stagelight {
namespace {

// Of a picture that the user gave no name. Whether it was missing.
bool make_folder(const std::filesystem::path &out) {
    const std::filesystem::path folder = out.parent_path();
    std::error_code error;
    const bool is_new = !exists(folder) && create_directories(folder, error);
    if (error) {
        throw UserError(fmt::format("{}: the folder {} can't be made: {}; --out names another",
                                    out.string(), folder.string(), error.message()));
    }
    return is_new;
}

// All that the run may write. A window that nobody demanded may give way to a picture file.
void require_outputs(const Run &run) {
    const Options &options = run.options;
    if (options.export_pov) {
        require_writable_place(*options.export_pov);
        return;
    }
    if (options.out) {
        require_writable(*options.out);
    } else if (!options.window) {
        const std::filesystem::path out = default_out(run.stage);
        const bool is_new = make_folder(out);
        require_writable(out);
        if (is_new) {
            remove(out.parent_path());  // a run that fails leaves nothing
        }
    }
    if (options.stats) {
        require_writable_place(*options.stats);
    }
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

Scene scene_of(const Run &run) {
    Scene scene = load_scene(run.options.scene);
    const int stage = stage_number(run.stage);
    require_supported(scene, stage);
    warn(take_out_unsupported(scene, stage));
    warn(warnings_of(scene));
    return scene;
}

RenderSettings settings_of(const Run &run) {
    const Options &options = run.options;
    RenderSettings settings;
    settings.width = options.size ? options.size->first : run.scene.width;
    settings.height = options.size ? options.size->second : run.scene.height;
    settings.max_depth = options.depth.value_or(depth_of(run.scene, stage_number(run.stage)));
    settings.samples = options.samples;
    settings.methods = options.methods;
    settings.kernels = options.kernels;
    settings.split = options.split;
    return settings;
}

void export_scene(const Run &run) {
    const int number = stage_number(run.stage);
    const std::filesystem::path &file = *run.options.export_pov;
    if (choice(run.settings.methods, "interior") == "paper") {
        throw UserError("--export-pov: POV-Ray has no --method interior=paper");
    }
    export_pov(run.scene,
               {.width = run.settings.width,
                .height = run.settings.height,
                .max_depth = run.settings.max_depth,
                .decode = decode_of(number, run.settings.methods),
                .shows_normals = number == 1},
               file);
    fmt::print("wrote {}\n", file.string());
}

std::vector<cl::Device> devices_of(const Run &run) {
    return devices_to_try(run.options.device, !run.scene.textures.empty());
}

// Chooses methods and depth for --max-error, and says which. Of the devices, the one that they were
// measured on is left. Whether it is met.
bool choose_by_error(Run &run) {
    const double max_error = *run.options.max_error;
    RenderSettings &settings = run.settings;
    Budget budget;
    run.devices = {first_that_builds(devices_of(run), [&](const cl::Device &device) {
        fit_textures(run, device);
        budget = meet_budget(device, run.stage, run.scene, settings,
                             probe_methods(device, run.stage, run.scene, settings), max_error);
    })};
    fmt::print("for --max-error {}: {}\npredicted error {:.2g}, measured {:.2g}\n", max_error,
               to_string(budget.plan, settings.max_depth), budget.plan.error, budget.error);
    if (!budget.is_met) {
        fmt::print(stderr, "error: no methods meet --max-error {}; {:.2g} is the best reached\n",
                   max_error, budget.error);
    }
    settings.methods = budget.plan.methods;
    settings.max_depth = budget.plan.max_depth;
    run.startup.skip();
    return budget.is_met;
}

// In a window, or where there is none, for a file.
RunResult pictures(Run &run) {
    std::string reason = "no window was asked for";
    if (!run.options.display.empty()) {
        try {
            return show(run);
        } catch (const PresenterLost &lost) {
            reason = lost.what();
        }
        if (run.options.window) {
            throw MachineError(reason + "; --display none writes a picture file");
        }
        fmt::print("display: none: {}\n", reason);
        run.startup.done("window");
    }
    if (run.devices.empty()) {
        run.devices = devices_of(run);
    }
    return draw(run, reason);
}

void write_picture(Run &run, const RunResult &result) {
    if (!run.options.out) {
        make_folder(*result.file);
    }
    run.startup.skip();  // the frames after the first
    write_image(result.picture, *result.file,
                encode_of(stage_number(run.stage), result.settings.methods), run.options.split);
    if (result.display.frames.empty()) {  // else the first picture was one in the window
        run.startup.done("write");
    }
}

int run_to_end(Run &run) {
    require_outputs(run);
    run.startup.done("start");
    // Before OpenCL's drivers load, which is when they are first asked for: run_sandboxed forks,
    // and a child that is forked beside a loading library would find the loader locked for ever.
    run.scene = scene_of(run);
    run.settings = settings_of(run);
    if (run.options.export_pov) {
        export_scene(run);
        return exit_done;
    }
    run.startup.done("scene");
    const bool is_met = !run.options.max_error || choose_by_error(run);
    const RunResult result = pictures(run);
    if (result.file) {
        write_picture(run, result);
    }
    if (!result.frames.empty()) {
        report(run, result);
    }
    if (result.file) {
        fmt::print("wrote {}\n", result.file->string());
    }
    return is_met ? exit_done : exit_check_failed;
}

}  // namespace

int run_stage(const std::string &stage, int argc, const char *const *argv) {
    return run_main([&]() -> int {
        Run run{.stage = stage};
        std::optional<Options> options = parse_options(stage, argc, argv);
        if (!options) {
            return exit_done;
        }
        if (options->list_devices) {
            fmt::print("{}", list_devices());
            return exit_done;
        }
        run.options = *std::move(options);
        if (run.options.quiet) {
            silence_warnings();
        }
        return run_to_end(run);
    });
}

}  // namespace stagelight
