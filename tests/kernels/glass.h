// SPDX-License-Identifier: MIT
// What the tests of glass have in common.
#pragma once

#include <cmath>

#include "kernels/on_device.h"
#include "kernels/worst.h"
#include "reference/optics.h"
#include "reference/scenes.h"

namespace stagelight {

constexpr int glass_max_depth = 4;
inline const SceneNeeds with_glass{
    {"HAS_DIELECTRIC", 1}, {"MAX_DEPTH", glass_max_depth}, {"STACK_SIZE", glass_max_depth + 1}};

inline const Methods interior_paper{{"interior", "paper"}};

inline glm::dvec3 unit(const glm::vec4 &v) {
    return glm::normalize(glm::dvec3(v));
}

// A unit vector that meets `normal` at the angle of that cosine.
inline glm::dvec3 direction_at(reference::Dice &dice, const glm::dvec3 &normal, double cosine) {
    const glm::dvec3 along = glm::normalize(glm::cross(normal, dice.direction()));
    return -cosine * normal + std::sqrt(1 - cosine * cosine) * along;
}

// Where float knows sin₂² = `sine_squared`, worked out with the square of `ratio`, only up to
// `rounding`, it knows cos₂ = sqrt(1 - sin₂²) up to this.
struct Snell {
    double sine_squared, rounding, cosine_rounding;
    bool certain;  // that light passes, or does not

    Snell(const glm::dvec3 &direction, const glm::dvec3 &normal, double ratio) {
        const double cosine = glm::dot(direction, normal);
        sine_squared = ratio * ratio * (1 - cosine * cosine);
        rounding = 4 * ulp * ratio * ratio + ulp;
        const double cosine_squared = std::abs(1 - sine_squared);
        cosine_rounding = rounding / std::sqrt(std::max(cosine_squared, rounding));
        certain = cosine_squared > rounding;
    }
};

}  // namespace stagelight
