// SPDX-License-Identifier: MIT
// ./stagelight bench: what each stage's default scene costs, by the stage's own program and by the
// full tracer's, and how right their pictures are.
#include <map>

#include <fmt/format.h>

#include "app/run_main.h"
#include "bench/collected_runs.h"
#include "bench/measured_program.h"
#include "bench/stages.h"
#include "device/device_choice.h"
#include "scene/errors.h"
#include "scene/scene_file.h"
#include "scene/stages.h"

namespace stagelight::bench {
namespace {

// A stage's scene by its own program, then by the full tracer's where that is another.
using Programs = std::vector<MeasuredProgram>;

Programs prepare(const cl::Device &device, const std::string &stage) {
    say(stage);
    const Scene scene =
        load_scene(std::filesystem::path(STAGELIGHT_SOURCE_DIR) / "scenes" / (stage + ".toml"));
    Programs programs;
    programs.emplace_back(device, stage, scene);
    if (stage != full_tracer()) {
        programs.emplace_back(device, full_tracer(), scene);
    }
    return programs;
}

// Draws in turn, as often as Google Benchmark wants: slow stages seldom, fast ones often.
void measure(benchmark::State &state, Programs &programs) {
    for (auto _ : state) {
        for (std::size_t i = 0; i < programs.size(); ++i) {
            const double seconds = programs[i].draw() / 1000;
            if (i == 0) {
                state.SetIterationTime(seconds);
            }
        }
    }
}

using Measured = std::map<std::string, Programs>;

std::vector<std::string> row(const std::string &stage, const Programs &programs) {
    const MeasuredProgram &own = programs.front();
    const double middle = median(own.milliseconds());
    std::vector<std::string> cells{
        stage,
        fmt::format("{:.1f}", middle),
        fmt::format("{}", own.milliseconds().size()),
        fmt::format("{:.2f}", own.rays().rate(middle)),
        fmt::format("{:.0f}", own.build().kernel),
        own.build().tree > 0 ? fmt::format("{:.0f}", own.build().tree) : "",
        fmt::format("{:.2f}", static_cast<double>(own.bytes()) / (1 << 20)),
        fmt::format("{:.1e}", own.comparison().worst_interior),
        fmt::format("{}", outliers_of(own.comparison())),
        fmt::format("{:.1e}", own.comparison().rmse)};
    if (programs.size() > 1) {
        const MeasuredProgram &full = programs.back();
        const double of_full = median(full.milliseconds());
        cells.push_back(fmt::format("{:.1f}", of_full));
        cells.push_back(fmt::format("{:.2f}", of_full / middle));
        cells.push_back(fmt::format("{:.1e}", full.comparison().rmse));
    }
    return cells;
}

void print_table(const Measured &measured) {
    std::vector<std::vector<std::string>> rows{{"", "ms", "runs", "million rays/s", "kernel, ms",
                                                "tree, ms", "MiB", "worst interior", "pixels off",
                                                "RMSE", "full tracer, ms", "to own", "its RMSE"}};
    for (const auto &[stage, programs] : measured) {
        rows.push_back(row(stage, programs));
    }
    fmt::print("{}", table(rows));
}

ordered_json json_of(const Measured &measured) {
    ordered_json json = ordered_json::array();
    for (const auto &[stage, programs] : measured) {
        ordered_json entry{{"scene", stage + ".toml"}, {"own", programs.front().json()}};
        if (programs.size() > 1) {
            entry["full_tracer"] = programs.back().json();
        }
        json.push_back(entry);
    }
    return json;
}

int bench_stages(int argc, char **argv) {
    const std::filesystem::path file = report_file("bench.json");
    const cl::Device device = choose_device("");
    Measured measured;
    for (const std::string &stage : stage_names()) {
        benchmark::RegisterBenchmark(stage.c_str(),
                                     [&, stage](benchmark::State &state) {
                                         if (!measured.contains(stage)) {
                                             measured.emplace(stage, prepare(device, stage));
                                         }
                                         measure(state, measured.at(stage));
                                     })
            ->UseManualTime()
            ->MinTime(0.5)
            ->Repetitions(3);
    }
    CollectedRuns runs;
    const int code = run_benchmarks(argc, argv, runs);
    if (code == exit_done) {
        fmt::print("{}\n", device.getInfo<CL_DEVICE_NAME>());
        print_table(measured);
        write_report({{"device", device_json(device)}, {"scenes", json_of(measured)}}, file);
    }
    return code;
}

}  // namespace
}  // namespace stagelight::bench

int main(int argc, char **argv) {
    return stagelight::run_main([&] { return stagelight::bench::bench_stages(argc, argv); });
}
