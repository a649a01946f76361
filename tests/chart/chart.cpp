// SPDX-License-Identifier: MIT
// ./stagelight chart: time against error of every method, on scenes of different needs.
#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/run_main.h"
#include "app/stats.h"
#include "chart/scene_chart.h"
#include "device/device_choice.h"
#include "scene/errors.h"

namespace stagelight::chart {
namespace {

// Spheres and lights; mirrors; glass spheres; textured meshes; a mesh of 70,000 triangles; all of
// it.
const std::vector<std::string> scenes{"02_lights", "03_mirrors", "04_interior",
                                      "08_gamma",  "09_tree",    "11_full_tracer"};

struct Arguments {
    std::vector<std::filesystem::path> scenes;
    std::string device;
    bool quick = false;
};

std::optional<Arguments> parse(int argc, const char *const *argv) {
    Arguments arguments;
    CLI::App app("Charts time against error of every method", "chart");
    app.add_option("--scene", arguments.scenes,
                   "a scene in TOML, or several (default: six of the project's)");
    app.add_option("--device", arguments.device, "as for run");
    app.add_flag("--quick", arguments.quick,
                 "small pictures of two scenes, in under two minutes: to see that all is well");
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp &) {
        fmt::print("{}", app.help());
        return std::nullopt;
    } catch (const CLI::ParseError &error) {
        throw UserError(fmt::format("{} (--help lists the options)", error.what()));
    }
    if (arguments.scenes.empty()) {
        for (const std::string &name : scenes) {
            const bool is_quick = name == "04_interior" || name == "08_gamma";
            if (!arguments.quick || is_quick) {
                arguments.scenes.push_back(std::filesystem::path(STAGELIGHT_SOURCE_DIR) / "scenes"
                                           / (name + ".toml"));
            }
        }
    }
    return arguments;
}

void print(const SceneChart &chart) {
    std::vector<std::vector<std::string>> rows{
        {chart.name, "time", "RMSE", "worst interior", "seen", "front"}};
    for (const Point &point : chart.points) {
        rows.push_back({point.kind + '=' + point.name + (point.is_default ? " (default)" : ""),
                        fmt::format("{:.3f}", point.ratio), fmt::format("{:.2e}", point.rmse),
                        fmt::format("{:.2e}", point.worst_interior),
                        fmt::format("{}", point.perceptual_failures), point.on_front ? "*" : ""});
    }
    say(bench::table(rows));
    for (const Met &met : chart.budgets) {
        say(fmt::format("--max-error {}: {:.2f} of the time, error {:.2e} ({:.2e} predicted), {}{}",
                        met.max_error, met.ratio, met.measured, met.predicted, met.plan,
                        met.is_met ? "" : ": NOT MET"));
    }
    for (const LeftOut &left : chart.left_out) {
        say(fmt::format("left out: {}: {}", left.method, left.why));
    }
}

int chart(int argc, const char *const *argv) {
    const std::optional<Arguments> arguments = parse(argc, argv);
    if (!arguments) {
        return exit_done;
    }
    const cl::Device device = choose_device(arguments->device);
    ChartSettings settings;
    settings.folder = std::filesystem::path("out") / "chart";
    if (arguments->quick) {
        settings.width = 160;
        settings.rounds = 3;
        settings.with_budgets = false;
        settings.with_samples = false;
    }
    const std::filesystem::path file = bench::report_file("chart/chart.json");
    ordered_json charts;
    Progress progress("charting", arguments->scenes.size());
    for (const std::filesystem::path &scene : arguments->scenes) {
        const SceneChart chart = chart_scene(device, scene, settings);
        print(chart);
        charts.push_back(json_of(chart));
        progress.step();
    }
    bench::write_report({{"device", device_json(device)},
                         {"quick", arguments->quick},
                         {"rounds", settings.rounds},
                         {"scenes", charts}},
                        file);
    return exit_done;
}

}  // namespace
}  // namespace stagelight::chart

int main(int argc, char **argv) {
    return stagelight::run_main([&] { return stagelight::chart::chart(argc, argv); });
}
