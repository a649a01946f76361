// SPDX-License-Identifier: MIT
// What every method costs on one scene and one device, and how wrong its picture is.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bench/report.h"
#include "device/opencl.h"
#include "scene/scene.h"

namespace stagelight::chart {

using bench::ordered_json;

// A method, beside the default of its kind.
struct Point {
    std::string kind;
    std::string name;
    bool is_default = false;
    double ratio = 1;           // its time over that of all defaults
    double rmse = 0;            // linear light, against the truth
    double worst_interior = 0;  // as Comparison has it
    int perceptual_failures = 0;
    bool on_front = false;  // no method of its kind is faster and as right, or as fast and righter
    std::string picture;  // PNG beside chart.json; and what it differs from the truth by, 16 times
    std::string difference;
};

// What was not drawn.
struct LeftOut {
    std::string method;
    std::string why;
};

// --max-error on the scene.
struct Met {
    double max_error = 0;
    std::string plan;
    double predicted = 0;
    double measured = 0;
    bool is_met = false;
    double ratio = 1;  // its time over that of all defaults
};

struct SceneChart {
    std::string name;
    int width = 0;
    int height = 0;
    double milliseconds = 0;  // of all defaults
    std::vector<Point> points;
    std::vector<LeftOut> left_out;
    std::vector<Met> budgets;
};

struct ChartSettings {
    int width = 320;  // pixels; the height follows the scene's shape
    int rounds = 9;
    bool with_budgets = true;
    bool with_samples = true;
    std::filesystem::path folder;  // for chart.json and its pictures
};

// Draws the scene by each method that matters to it, each in turn with the defaults.
SceneChart chart_scene(const cl::Device &device, const std::filesystem::path &file,
                       const ChartSettings &settings);

// Sets on_front of every point, among those of its kind.
void find_fronts(std::vector<Point> &points);

ordered_json json_of(const SceneChart &chart);

}  // namespace stagelight::chart
