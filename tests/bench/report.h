// SPDX-License-Identifier: MIT
// What the benches have in common: figures in a table on stdout and in a JSON file.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/stats.h"
#include "image/compare.h"
#include "scene/progress.h"

namespace stagelight::bench {

using nlohmann::ordered_json;

// out/NAME below the current folder, which is made if need be. Throws UserError where nothing can
// be written: asked before anything is measured.
std::filesystem::path report_file(const std::string &name);

void write_report(const ordered_json &report, const std::filesystem::path &file);

// Rows of cells as text, a line each, the first being the titles: columns as wide as they need,
// numbers to the right, the first column to the left.
std::string table(const std::vector<std::vector<std::string>> &rows);

// Says on stderr what is being done.
void say(const std::string &what);

// Milliseconds that `work` takes.
double time_of(const auto &work) {
    const double start = now_milliseconds();
    work();
    return now_milliseconds() - start;
}

// The median of `runs` times.
double median_time_of(int runs, const auto &work) {
    std::vector<double> times;
    for (int i = 0; i < runs; ++i) {
        times.push_back(time_of(work));
    }
    return median(std::move(times));
}

// What `draw(i)` returns for each i below `count`, in turn, `rounds` times: what slows the machine
// down for a while slows all. By i.
std::vector<std::vector<double>> in_turn(std::size_t count, int rounds, const auto &draw) {
    std::vector<std::vector<double>> times(count);
    Progress progress("timing", count * static_cast<std::size_t>(rounds));
    for (int round = 0; round < rounds; ++round) {
        for (std::size_t i = 0; i < count; ++i) {
            times[i].push_back(draw(i));
            progress.step();
        }
    }
    return times;
}

// Pixels more than the tolerance off, inside surfaces and on edges.
inline int outliers_of(const Comparison &comparison) {
    return comparison.interior_outliers + comparison.edge_outliers + comparison.strays;
}

// The exponent p of the power law y = c x^p that fits best: the slope of a line through the
// logarithms, by least squares. Of two points or more, all above 0.
double fitted_exponent(const std::vector<double> &x, const std::vector<double> &y);

}  // namespace stagelight::bench
