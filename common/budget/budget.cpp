// SPDX-License-Identifier: MIT
#include "budget/budget.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include <fmt/format.h>

#include "budget/truth.h"
#include "device/renderer.h"
#include "scene/progress.h"

namespace stagelight {
namespace {

constexpr int most_tries = 6;
constexpr double worthwhile = 0.98;  // times are measured no better than that

using Options = std::vector<Probe>;

// By kind, what it may be worth to choose; those that another of their kind betters are left out.
std::vector<Options> options_of(const Probes &probes) {
    std::map<std::string, Options> by_kind;
    for (const Probe &probe : probes.probes) {
        const auto betters = [&probe](const Probe &other) {
            return other.kind == probe.kind && other.ratio <= probe.ratio
                   && other.error <= probe.error && other.name != probe.name;
        };
        if (probe.ratio < worthwhile && std::ranges::none_of(probes.probes, betters)) {
            by_kind[probe.kind].push_back(probe);
        }
    }
    std::vector<Options> options;
    options.reserve(by_kind.size());
    for (const auto &[kind, of_kind] : by_kind) {
        options.push_back(of_kind);
    }
    return options;
}

// Tries all combinations, a kind at a time, but those that are over the limit already.
class Search {
public:
    Search(const Probes &probes, double limit)
        : options_(options_of(probes)), limit_squared_(limit * limit),
          base_squared_(probes.base_error * probes.base_error) {}

    std::vector<Probe> best() {
        go_on(0, 1, base_squared_);
        return best_;
    }

private:
    void go_on(std::size_t kind, double ratio, double squared) {
        if (kind == options_.size()) {
            if (ratio < best_ratio_) {
                best_ratio_ = ratio;
                best_ = chosen_;
            }
            return;
        }
        go_on(kind + 1, ratio, squared);
        for (const Probe &probe : options_[kind]) {
            const double with = squared + probe.error * probe.error;
            if (with <= limit_squared_) {
                chosen_.push_back(probe);
                go_on(kind + 1, ratio * probe.ratio, with);
                chosen_.pop_back();
            }
        }
    }

    std::vector<Options> options_;
    double limit_squared_;
    double base_squared_;
    std::vector<Probe> chosen_;
    std::vector<Probe> best_;
    double best_ratio_ = 2;
};

Plan plan_in_double(const Probes &probes, int max_depth) {
    Plan plan{probes.base, max_depth, probes.in_double->error, probes.in_double->ratio};
    plan.methods[probes.in_double->kind] = probes.in_double->name;
    return plan;
}

}  // namespace

Plan cheapest_plan(const Probes &probes, int max_depth, double limit) {
    Plan plan{probes.base, max_depth, 0, 1};
    double squared = probes.base_error * probes.base_error;
    for (const Probe &probe : Search(probes, limit).best()) {
        if (probe.kind == "limit") {
            plan.max_depth = std::stoi(probe.name);
        } else {
            plan.methods[probe.kind] = probe.name;
        }
        squared += probe.error * probe.error;
        plan.ratio *= probe.ratio;
    }
    plan.error = std::sqrt(squared);
    return plan;
}

Budget meet_budget(const cl::Device &device, const std::string &stage, const Scene &scene,
                   const RenderSettings &settings, const Probes &probes, double max_error) {
    const Image truth = truth_of(stage, scene, settings).image;
    Budget best{.plan = {}, .error = INFINITY};
    const auto error_of = [&](const Plan &plan) {
        RenderSettings with = settings;
        with.methods = plan.methods;
        with.max_depth = plan.max_depth;
        const double error = rmse_of(Renderer(device, stage, scene, with).render().image, truth);
        if (error <= max_error || error < best.error) {
            best = {plan, error, error <= max_error};
        }
        return error;
    };
    double aim = max_error;
    for (int i = 0; i < most_tries && !best.is_met; ++i) {
        const Plan plan = cheapest_plan(probes, settings.max_depth, aim);
        const double error = error_of(plan);
        if (plan.ratio == 1) {
            break;  // the base: nothing in float is more accurate
        }
        aim = 0.9 * std::min(aim, plan.error * std::min(1.0, max_error / error));
    }
    if (!best.is_met && probes.in_double) {
        error_of(plan_in_double(probes, settings.max_depth));
    }
    return best;
}

std::string to_string(const Plan &plan, int max_depth) {
    std::string text;
    const auto add = [&text](const std::string &kind, const std::string &name) {
        text += fmt::format("{}{}={}", text.empty() ? "" : ", ", kind, name);
    };
    for (const auto &[kind, name] : plan.methods) {
        if (name != choice({}, kind)) {
            add(kind, name);
        }
    }
    if (plan.max_depth < max_depth) {
        add("depth limit", std::to_string(plan.max_depth));
    }
    return text.empty() ? "the defaults" : text;
}

}  // namespace stagelight
