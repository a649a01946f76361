// SPDX-License-Identifier: MIT
// What goes wrong where arithmetic is done the device's fastest way. The truth is long double.
#include <cmath>
#include <limits>

#include "kernels/on_device.h"
#include "reference/scenes.h"
#include "stability/sweep.h"

namespace stagelight::stability {
namespace {

using glm::dvec3, glm::vec3, glm::vec4;
using reference::Dice;
using Real = long double;
using Exact = glm::vec<3, Real>;

using StabilityStage01Normalise = OnDevice;
INSTANTIATE_TEST_SUITE_P(On, StabilityStage01Normalise, each_device(), device_name);
using StabilityStage01Math = OnDevice;
INSTANTIATE_TEST_SUITE_P(On, StabilityStage01Math, each_device(), device_name);

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
const char *const maths[] = {"strict", "mad", "relaxed"};

struct Units {
    vec4 one, wide;
};

TEST_P(StabilityStage01Normalise, LongAndShort) {
    Dice dice;
    std::vector<double> x;
    std::vector<vec4> vectors;
    for (int power = 0; power <= 44; ++power) {
        for (int i = 0; i < 32; ++i) {
            x.push_back(std::pow(10, power / 2.0));
            vectors.emplace_back(vec3(dice.direction() * (i % 2 == 0 ? x.back() : 1 / x.back())),
                                 0);
        }
    }
    Sweep sweep({.name = "normalise",
                 .kind = "normalise",
                 .title = "Long and short vectors",
                 .x_label = "length, or 1 / length",
                 .y_label = "error of the unit vector",
                 .limit = 1e-6,
                 .stated = "lengths from 1e-18 to 1e18"},
                GetParam());
    for (const std::string method : {"exact", "native"}) {
        const auto units = build("arithmetic.cl", {{"WIDTH", 4}}, {{"normalise", method}})
                               .run<Units>("units", vectors);
        for (std::size_t i = 0; i < units.size(); ++i) {
            const Exact truth = glm::normalize(Exact(vectors[i]));
            sweep.add(method, x[i], double(glm::distance(Exact(units[i].one), truth)));
            sweep.add(method + ", wide", x[i], double(glm::distance(Exact(units[i].wide), truth)));
        }
    }
    for (const char *method : {"exact", "exact, wide", "native", "native, wide"}) {
        sweep.expect_holds(method, 1e18);
    }
    // The built-in normalize scales; where the square is written out, float has none.
    sweep.expect_holds("exact", 1e22);
    sweep.expect_fails("exact, wide", 1e20);
    sweep.expect_fails("native", 1e20);
    sweep.expect_fails("native, wide", 1e20);
}

// sqrt(a * a - b * b) where b is all but a: each product rounded by itself, it is never the root of
// a number below 0.
TEST_P(StabilityStage01Math, RootsOfDifferences) {
    Dice dice;
    std::vector<double> x;
    std::vector<float> longest, side;
    for (int power = 0; power <= 32; ++power) {
        for (int i = 0; i < 64; ++i) {
            x.push_back(std::pow(10, power / 4.0));
            longest.push_back(float(dice.between(1, 10)));
            side.push_back(float(longest.back() * (1 - 1 / x.back())));
        }
    }
    Sweep sweep({.name = "math_root",
                 .kind = "math",
                 .title = "The root of a difference of squares",
                 .x_label = "1 / relative difference",
                 .y_label = "error, relative to the longest side",
                 .limit = 1e-3,
                 .stated = "to no difference at all"},
                GetParam());
    for (const char *method : maths) {
        const auto sides = build("arithmetic.cl", {{"WIDTH", 4}}, {{"math", method}})
                               .run<float>("other_sides", longest, side);
        for (std::size_t i = 0; i < sides.size(); ++i) {
            const Real a = longest[i], b = side[i];
            const Real truth = std::sqrt((a - b) * (a + b));
            sweep.add(method, x[i], double(std::abs(sides[i] - truth) / a));
        }
    }
    sweep.expect_holds("strict", 1e8);
    if (!on_rusticl()) {  // which contracts nothing, whatever it is allowed
        sweep.expect_fails("mad", 1e8);
        sweep.expect_fails("relaxed", 1e8);
    }
}

// Rays that pass a sphere by: half the chord is the root of a number below 0.
TEST_P(StabilityStage01Math, Misses) {
    Dice dice;
    std::vector<double> x;
    std::vector<vec4> origins, directions;
    for (int power = 0; power <= 16; ++power) {
        for (int i = 0; i < 32; ++i) {
            const dvec3 way = dice.direction();
            const dvec3 aside = glm::normalize(glm::cross(way, dice.direction()));
            x.push_back(std::pow(10, power / 4.0));
            origins.emplace_back(vec3((1 + 1 / x.back()) * aside - 4.0 * way), 0);
            directions.emplace_back(vec3(way), 0);
        }
    }
    Sweep sweep({.name = "math_miss",
                 .kind = "math",
                 .title = "Rays that miss a sphere",
                 .x_label = "radius / distance from the sphere",
                 .y_label = "1 where a miss becomes a hit",
                 .limit = 0.5,
                 .stated = "to 1e-4 of the radius"},
                GetParam());
    for (const char *method : maths) {
        const auto distances = build("arithmetic.cl", {{"WIDTH", 4}}, {{"math", method}})
                                   .run<float>("spheres", origins, directions);
        for (std::size_t i = 0; i < distances.size(); ++i) {
            sweep.add(method, x[i], distances[i] == -1 ? 0 : 1);
        }
    }
    sweep.expect_holds("strict", 1e4);  // and so do the others, on both devices
}

// The second of two is chosen where the first is not a number; what differs from itself is none.
TEST_P(StabilityStage01Math, WhatIsNotANumber) {
    for (const char *method : maths) {
        const auto choices =
            build("arithmetic.cl", {{"WIDTH", 4}}, {{"math", method}})
                .run<vec4>("choices", std::vector{not_a_number, 2.0F}, std::vector{1.0F, 1.0F});
        EXPECT_EQ(vec3(choices[0]), vec3(1, 1, 0)) << method;
        EXPECT_EQ(choices[1], vec4(1, 2, 1, 1)) << method;
        if (method != std::string("relaxed")) {
            EXPECT_EQ(choices[0].w, 0) << method;
        } else if (!on_rusticl()) {
            EXPECT_EQ(choices[0].w, 1) << "PoCL takes each number for equal to itself";
        }
    }
}

}  // namespace
}  // namespace stagelight::stability
