// SPDX-License-Identifier: MIT
#include "budget/truth.h"

#include <cmath>

#include <glm/geometric.hpp>

#include "scene/progress.h"
#include "scene/stages.h"

namespace stagelight {

reference::Result truth_of(const std::string &stage, const Scene &scene,
                           const RenderSettings &settings) {
    const Progress progress("drawing the reference");
    const int number = stage_number(stage);
    return reference::render<double>(scene, {.width = settings.width,
                                             .height = settings.height,
                                             .max_depth = settings.max_depth,
                                             .fresnel = reference::Fresnel::exact,
                                             .terminator = number < cutoff_stage
                                                               ? reference::Terminator::none
                                                               : reference::Terminator::hanika,
                                             .decode = decode_of(number, {})});
}

double rmse_of(const Image &picture, const Image &truth) {
    double sum = 0;
    for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
        const glm::dvec3 error = glm::dvec3(picture.pixels[i]) - glm::dvec3(truth.pixels[i]);
        sum += glm::dot(error, error);
    }
    const double mean = sum / (3 * static_cast<double>(truth.pixels.size()));
    return std::isfinite(mean) ? std::sqrt(mean) : INFINITY;
}

}  // namespace stagelight
