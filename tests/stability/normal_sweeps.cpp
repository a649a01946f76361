// SPDX-License-Identifier: MIT
// How far the normals of smooth meshes are turned, and what they reflect. The truth is double, in
// which the mesh was made.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "kernels/on_device.h"
#include "reference/scenes.h"
#include "scene_types.h"
#include "stability/sweep.h"

namespace stagelight::stability {
namespace {

using glm::dvec3, glm::vec4;
using reference::Dice;
using Triangle = std::array<dvec3, 3>;

// Facets of the unit ball, whose normals are their corners, each with a point of it and a ray to
// there.
struct SmoothFacets {
    std::vector<double> x;
    std::vector<Triangle> facets;
    std::vector<vec4> weights, directions;
    Dice dice;

    void add(double at, const Triangle &facet) {
        const double b = dice.between(0, 1);
        x.push_back(at);
        facets.push_back(facet);
        weights.emplace_back(b, dice.between(0, 1 - b), 0, 0);
        directions.emplace_back(dice.direction(), 0);
    }

    // Not yet of unit length.
    dvec3 blended(std::size_t i) const {
        const double b = weights[i].x, c = weights[i].y;
        return (1 - b - c) * facets[i][0] + b * facets[i][1] + c * facets[i][2];
    }
};

double angle(const dvec3 &a, const dvec3 &b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

// How far a normal, and a ray reflected by it, are turned, in radians.
struct Turn {
    double normal, reflected;
};

std::vector<Turn> turns(DeviceProgram program, const SmoothFacets &cases) {
    std::vector<std::array<device::float4, 3>> corners;  // on the unit sphere: their own normals
    std::vector<device::Triangle> triangles;
    for (const Triangle &facet : cases.facets) {
        const auto first = std::uint32_t(3 * corners.size());
        triangles.push_back({{first, first + 1, first + 2}, 0});
        auto &out = corners.emplace_back();
        for (std::size_t corner = 0; corner < 3; ++corner) {
            for (int axis = 0; axis < 3; ++axis) {
                out[corner].s[axis] = float(facet[corner][axis]);
            }
        }
    }
    const auto read = program.run<std::array<vec4, 2>>(
        "smooth_normals", cases.weights, cases.directions, triangles, corners, corners);
    std::vector<Turn> all;
    for (std::size_t i = 0; i < read.size(); ++i) {
        const dvec3 normal = glm::normalize(cases.blended(i));
        const dvec3 reflected = glm::reflect(dvec3(cases.directions[i]), normal);
        all.push_back({angle(dvec3(read[i][0]), normal), angle(dvec3(read[i][1]), reflected)});
    }
    return all;
}

// What a dozen roundings of float turn a direction by, at the most.
const double float_turn = std::ldexp(16, -24);

class StabilityStage09Normals : public OnDevice {
protected:
    static std::vector<Turn> turns_of(const SmoothFacets &cases) {
        return turns(
            build("smooth_normals.cl", {{"HAS_TRIANGLES", 1}, {"HAS_TREE", 1}, {"MAX_DEPTH", 1}}),
            cases);
    }
};
INSTANTIATE_TEST_SUITE_P(On, StabilityStage09Normals, each_device(), device_name);

TEST_P(StabilityStage09Normals, OfEveryDirection) {
    SmoothFacets cases;
    for (int power = 0; power <= 16; ++power) {
        const double x = std::pow(10, power / 2.0);
        for (int i = 0; i < 256; ++i) {
            const double turn = cases.dice.between(0, 2 * std::numbers::pi);
            dvec3 normal(0);
            normal[i % 3] = 1 / x;
            normal[(i + 1) % 3] = std::cos(turn);
            normal[(i + 2) % 3] = std::sin(turn);
            normal = glm::normalize(normal);
            cases.add(x, {normal, normal, normal});
        }
    }
    Sweep sweep({.name = "normals_turn",
                 .kind = "normals",
                 .title = "Normals, and what they reflect",
                 .x_label = "1 / one part of the normal",
                 .y_label = "degrees that it is turned by",
                 .limit = glm::degrees(float_turn),
                 .stated = "for every direction"},
                GetParam());
    const std::vector<Turn> all = turns_of(cases);
    for (std::size_t i = 0; i < all.size(); ++i) {
        sweep.add("normal", cases.x[i], glm::degrees(all[i].normal));
        sweep.add("reflected ray", cases.x[i], glm::degrees(all[i].reflected));
    }
    sweep.expect_holds("normal", 1e8);
    sweep.expect_holds("reflected ray", 1e8);
}

// Where facets are small, their corners' normals are nearly one and the same: a mirror shows the
// steps.
TEST_P(StabilityStage09Normals, OfFineMeshes) {
    SmoothFacets cases;
    for (int power = 2; power <= 16; ++power) {
        const double x = std::pow(10, power / 2.0);
        for (int i = 0; i < 256; ++i) {
            const dvec3 normal = cases.dice.direction();
            const dvec3 across = glm::normalize(glm::cross(normal, cases.dice.direction()));
            const double step = 2 * std::numbers::pi / x;
            const auto beside = [&](const dvec3 &way) {
                return std::cos(step) * normal + std::sin(step) * way;
            };
            cases.add(x, {normal, beside(across), beside(glm::cross(normal, across))});
        }
    }
    Sweep sweep({.name = "normals_fine",
                 .kind = "normals",
                 .title = "Mirrors of ever smaller facets",
                 .x_label = "facets around the mesh",
                 .y_label = "turn of a reflected ray / turn from corner to corner",
                 .limit = 0.1,
                 .stated = "to a million facets around"},
                GetParam());
    const std::vector<Turn> all = turns_of(cases);
    for (std::size_t i = 0; i < all.size(); ++i) {
        sweep.add("reflected ray", cases.x[i],
                  all[i].reflected / (2 * std::numbers::pi / cases.x[i]));
    }
    sweep.expect_holds("reflected ray", 1e6);
    sweep.expect_fails("reflected ray", 1e8);
}

}  // namespace
}  // namespace stagelight::stability
