// SPDX-License-Identifier: MIT
// --max-error: the cheapest way to draw a scene on a device that is still as right as asked for.
#pragma once

#include <string>

#include "budget/probes.h"

namespace stagelight {

// A set of methods and a depth limit, and what the probes let expect of it.
struct Plan {
    Methods methods;
    int max_depth = 0;
    double error = 0;  // RMSE against truth_of
    double ratio = 1;  // its milliseconds over those of the probes' base
};

// Of all sets that can be made of the probes, the fastest whose error is expected to be within
// `limit`; where none is, the base. Errors of different choices are taken to be independent: their
// squares add.
Plan cheapest_plan(const Probes &probes, int max_depth, double limit);

struct Budget {
    Plan plan;
    double error = 0;  // RMSE that was measured, at the picture's size
    bool is_met = false;
};

// The cheapest plan whose picture, drawn as `settings` say otherwise, is off from truth_of by at
// most `max_error`; where none in float is, the base in double, or else the one that comes nearest.
// The probes are of this scene and device.
Budget meet_budget(const cl::Device &device, const std::string &stage, const Scene &scene,
                   const RenderSettings &settings, const Probes &probes, double max_error);

// "fresnel=exact, limit=3", in a fixed order; "the defaults" for none.
std::string to_string(const Plan &plan, int max_depth);

}  // namespace stagelight
