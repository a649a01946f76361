// SPDX-License-Identifier: MIT
// What the reference, in double, is sure of in a scene, whatever float makes of it. An answer
// counts where it is the same for all rays that start within the margin of the one at hand:
// elsewhere it is a tie, or on an edge.
#pragma once

#include <optional>
#include <vector>

#include <glm/vec4.hpp>

#include "kernels/worst.h"
#include "reference/direct_light.h"
#include "reference/scenes.h"

namespace stagelight {

using World = reference::World<double>;
using Hit = reference::Hit<double>;
using Ray = reference::Ray<double>;
using Line = reference::Line<double>;

constexpr double margin = 1e-3;
// Float rounds coordinates of about 10 by 1e-6, a few times over: by no more than a 200th of the
// margin. So what varies over the margin by much may be off by a 200th of that.
constexpr double share_of_spread = 0.005;
constexpr double rounding = 4 * ulp * 10;

// A thousand random rays, or lines: `ends` are directions or destinations.
struct RandomWays {
    enum Kind { rays, lines };
    std::vector<glm::vec4> origins, ends;

    RandomWays(reference::Dice &dice, Kind kind);
    Ray ray(std::size_t i) const {
        return {glm::dvec3(origins[i]), glm::normalize(glm::dvec3(ends[i]))};
    }
    Line line(std::size_t i) const { return {glm::dvec3(origins[i]), glm::dvec3(ends[i])}; }
};

// What the ray meets, and then its neighbours; empty where that is not the same.
std::vector<Hit> certain_hits(const World &world, const Ray &ray);

// Whether anything is in the way.
std::optional<bool> certainly_blocked(const World &world, const Ray &ray);
std::optional<bool> certainly_blocked(const World &world, const Line &line);

// The lights' sum at a hit, how far it may be off, and how many lights the surface faces.
struct Lit {
    glm::dvec3 sum;
    double tolerance;
    int shadow_rays;
};

// Nothing where the neighbours lie in other shadows.
std::optional<Lit> certain_light(const World &world, const std::vector<Hit> &hits);

// How far from its value at the first hit a property may be in float.
template <typename Value>
double tolerance_of(const std::vector<Hit> &hits, const Value &value, double least) {
    double spread = 0;
    for (const Hit &hit : hits) {
        spread = std::max(spread, glm::distance(value(hit), value(hits[0])));
    }
    return least + share_of_spread * spread;
}

}  // namespace stagelight
