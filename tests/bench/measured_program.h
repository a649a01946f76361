// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "bench/report.h"
#include "device/renderer.h"
#include "image/compare.h"
#include "reference/reference.h"
#include "scene/scene.h"

namespace stagelight::bench {

// A stage's program on a scene, at the scene's own size: what it costs, and how right its picture
// is.
class MeasuredProgram {
public:
    // Draws once, untimed, and compares that picture with the reference's.
    MeasuredProgram(const cl::Device &device, const std::string &stage, const Scene &scene);

    // Draws once more; milliseconds.
    double draw();

    const std::string &stage() const { return stage_; }
    const std::vector<double> &milliseconds() const { return milliseconds_; }
    const RayTotals &rays() const { return rays_; }
    std::size_t bytes() const;
    const BuildTimes &build() const { return renderer_.stage_kernel().milliseconds(); }
    const Comparison &comparison() const { return comparison_; }
    ordered_json json() const;

private:
    std::string stage_;
    Renderer renderer_;
    RayTotals rays_;
    Comparison comparison_;
    std::vector<double> milliseconds_;
};

}  // namespace stagelight::bench
