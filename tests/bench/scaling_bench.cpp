// SPDX-License-Identifier: MIT
// ./stagelight bench scaling: how the full tracer's cost grows with triangles, pixels, lights and
// depth.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "app/run_main.h"
#include "bench/generated_scenes.h"
#include "bench/report.h"
#include "bench/stages.h"
#include "device/device_choice.h"
#include "device/renderer.h"
#include "scene/errors.h"

namespace stagelight::bench {
namespace {

constexpr int rounds = 7;

// What one size costs; a series of them is a row each in the table.
struct Cost {
    double size = 0;
    double milliseconds = 0;  // a frame
    double million_rays = 0;  // a second
    double tree_milliseconds = 0;
    double bytes_a_triangle = 0;
};

using Costs = std::vector<Cost>;

std::vector<double> column(const Costs &costs, double Cost::*figure) {
    std::vector<double> values(costs.size());
    std::ranges::transform(costs, values.begin(), figure);
    return values;
}

// All that lies on the device but the picture and what is counted for it.
double bytes_of_triangles(const Renderer &renderer) {
    double sum = 0;
    for (const auto &[name, bytes] : renderer.bytes()) {
        sum += name == "image" || name == "ray_counts" ? 0 : static_cast<double>(bytes);
    }
    return sum;
}

// The sizes of one thing, all kept to be timed in turn.
class Series {
public:
    explicit Series(const cl::Device &device) : device_(device) {}

    Cost &add(const Scene &scene, double size) {
        renderers_.emplace_back(device_, full_tracer(), scene, settings_of(full_tracer(), scene));
        costs_.push_back({.size = size});
        return costs_.back();
    }
    const Renderer &newest() const { return renderers_.back(); }

    Costs timed() {
        say(fmt::format("{} rounds over them all", rounds));
        std::vector<RayTotals> rays;
        for (Renderer &renderer : renderers_) {  // the first frame waits for the drivers
            rays.push_back(renderer.render().rays);
        }
        const auto times = in_turn(renderers_.size(), rounds, [this](std::size_t i) {
            return renderers_[i].render().milliseconds;
        });
        for (std::size_t i = 0; i < costs_.size(); ++i) {
            costs_[i].milliseconds = median(times[i]);
            costs_[i].million_rays = rays[i].rate(costs_[i].milliseconds);
        }
        return costs_;
    }

private:
    cl::Device device_;
    std::vector<Renderer> renderers_;
    Costs costs_;
};

Costs over_triangles(const cl::Device &device) {
    Series series(device);
    for (int n = 16; n <= 1024; n *= 2) {
        const Scene scene = ring(n);
        const auto count = static_cast<double>(scene.triangles.size());
        say(fmt::format("{} triangles", count));
        Cost &cost = series.add(scene, count);
        cost.tree_milliseconds = series.newest().stage_kernel().milliseconds().tree;
        cost.bytes_a_triangle = bytes_of_triangles(series.newest()) / count;
    }
    return series.timed();
}

// The time of each size from the first to the last but 4 million, over what it would be if it grew
// with the logarithm: the largest.
double growth_over_logarithm(const Costs &costs) {
    constexpr double most_triangles = 1.1e6;
    double largest = 0;
    for (const Cost &cost : costs) {
        if (cost.size < most_triangles) {
            const double logarithmic =
                costs.front().milliseconds * std::log(cost.size) / std::log(costs.front().size);
            largest = std::max(largest, cost.milliseconds / logarithmic);
        }
    }
    return largest;
}

Costs over_pixels(const cl::Device &device) {
    Series series(device);
    Scene scene = ring(128);
    for (int side = 128; side <= 2048; side *= 2) {
        say(fmt::format("{0}x{0} pixels", side));
        scene.width = scene.height = side;
        series.add(scene, static_cast<double>(side) * side);
    }
    return series.timed();
}

Costs over_doublings(const cl::Device &device, const char *what, Scene (*make)(int)) {
    Series series(device);
    for (int count = 1; count <= 64; count *= 2) {
        say(fmt::format("{} {}", what, count));
        series.add(make(count), count);
    }
    return series.timed();
}

double exponent_of(const Costs &costs) {
    return fitted_exponent(column(costs, &Cost::size), column(costs, &Cost::milliseconds));
}

void print_costs(const char *what, const Costs &costs) {
    std::vector<std::vector<std::string>> rows{{what, "ms", "million rays/s"}};
    const bool has_tree = costs.front().tree_milliseconds > 0;
    if (has_tree) {
        rows[0].insert(rows[0].end(), {"tree, ms", "bytes a triangle"});
    }
    for (const Cost &cost : costs) {
        rows.push_back({fmt::format("{}", cost.size), fmt::format("{:.1f}", cost.milliseconds),
                        fmt::format("{:.1f}", cost.million_rays)});
        if (has_tree) {
            rows.back().push_back(fmt::format("{:.1f}", cost.tree_milliseconds));
            rows.back().push_back(fmt::format("{:.1f}", cost.bytes_a_triangle));
        }
    }
    fmt::print("\n{}time grows with {} to the power of {:.2f}\n", table(rows), what,
               exponent_of(costs));
}

ordered_json json_of(const Costs &costs) {
    ordered_json sizes = ordered_json::array();
    for (const Cost &cost : costs) {
        ordered_json entry{{"size", cost.size},
                           {"milliseconds", cost.milliseconds},
                           {"million_rays_per_second", cost.million_rays}};
        if (cost.tree_milliseconds > 0) {
            entry["tree_milliseconds"] = cost.tree_milliseconds;
            entry["bytes_a_triangle"] = cost.bytes_a_triangle;
        }
        sizes.push_back(entry);
    }
    return {{"exponent", exponent_of(costs)}, {"sizes", sizes}};
}

// The check that the logarithm's law is put to: a quarter more is allowed.
void tell_growth(double growth) {
    constexpr double allowed = 1.25;
    fmt::print("to a million triangles it takes at most {:.2f} times what the logarithm's law from "
               "the first on gives: {} the {:.2f} allowed\n",
               growth, growth <= allowed ? "within" : "BEYOND", allowed);
}

int bench_scaling(int argc) {
    if (argc > 1) {
        throw UserError("bench scaling takes no options; STAGELIGHT_DEVICE chooses the device");
    }
    const std::filesystem::path file = report_file("bench_scaling.json");
    const cl::Device device = choose_device("");
    fmt::print("{}, {}\n", full_tracer(), device.getInfo<CL_DEVICE_NAME>());
    ordered_json report{{"device", device_json(device)}, {"stage", full_tracer()}};
    const auto tell = [&report](const char *what, const Costs &costs) {
        print_costs(what, costs);
        report[what] = json_of(costs);
    };
    const Costs triangles = over_triangles(device);
    tell("triangles", triangles);
    report["triangles"]["growth_over_logarithm"] = growth_over_logarithm(triangles);
    tell_growth(growth_over_logarithm(triangles));
    tell("pixels", over_pixels(device));
    tell("lights", over_doublings(device, "lights:", ring_in_lights));
    tell("depth", over_doublings(device, "depth:", facing_mirrors));
    write_report(report, file);
    return exit_done;
}

}  // namespace
}  // namespace stagelight::bench

int main(int argc, char **) {
    return stagelight::run_main([&] { return stagelight::bench::bench_scaling(argc); });
}
