// SPDX-License-Identifier: MIT
#include "bench/measured_program.h"

#include "bench/stages.h"

namespace stagelight::bench {
namespace {

// Each kind in million rays a second.
ordered_json rates_json(const RayTotals &rays, double milliseconds) {
    ordered_json rates = rays_json(rays);
    for (auto &rate : rates) {
        rate = rate.get<double>() / milliseconds / 1000;
    }
    rates["all"] = rays.rate(milliseconds);
    return rates;
}

ordered_json error_json(const Comparison &comparison) {
    return {{"worst_interior", comparison.worst_interior},
            {"pixels_off", outliers_of(comparison)},
            {"mean_signed", comparison.mean_signed_error},
            {"rmse", comparison.rmse}};
}

}  // namespace

MeasuredProgram::MeasuredProgram(const cl::Device &device, const std::string &stage,
                                 const Scene &scene)
    : stage_(stage), renderer_(device, stage, scene, settings_of(stage, scene)) {
    const Frame first = renderer_.render();
    const reference::Result truth = reference_of(stage, scene, settings_of(stage, scene));
    rays_ = first.rays;
    comparison_ = compare(first.image, truth.image, truth.edge, Tolerance());
}

double MeasuredProgram::draw() {
    milliseconds_.push_back(renderer_.render().milliseconds);
    return milliseconds_.back();
}

std::size_t MeasuredProgram::bytes() const {
    return bytes_json(renderer_.bytes()).at("total").get<std::size_t>();
}

ordered_json MeasuredProgram::json() const {
    const double middle = median(milliseconds_);
    return {{"stage", stage_},
            {"build",
             {{"options", renderer_.stage_kernel().options()},
              {"kernel_milliseconds", build().kernel},
              {"tree_milliseconds", build().tree}}},
            {"milliseconds", milliseconds_},
            {"median", middle},
            {"rays", rays_json(rays_)},
            {"million_rays_per_second", rates_json(rays_, middle)},
            {"bytes_on_device", bytes_json(renderer_.bytes())},
            {"error", error_json(comparison_)}};
}

}  // namespace stagelight::bench
