// SPDX-License-Identifier: MIT
// Rays that slip through between two triangles.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "kernels/on_device.h"
#include "reference/scenes.h"
#include "stability/leaf_triangles.h"
#include "stability/sweep.h"

namespace stagelight::stability {
namespace {

using glm::dvec3;
using reference::Dice;

using StabilityStage09Leaks = OnDevice;
INSTANTIATE_TEST_SUITE_P(On, StabilityStage09Leaks, each_device(), device_name);

// Four corners, any three of which have a triangle, with some room within.
using Mesh = std::array<Corners, 4>;

Mesh some_mesh(double offset, Dice &dice) {
    const dvec3 at = offset * dice.direction();
    const double scale = std::pow(10, dice.between(-3, 3));
    for (;;) {
        std::array<dvec3, 4> corners;
        for (dvec3 &corner : corners) {
            corner = dice.in_cube(1);
        }
        const double volume = glm::determinant(
            glm::dmat3(corners[1] - corners[0], corners[2] - corners[0], corners[3] - corners[0]));
        if (std::abs(volume) > 0.5) {
            Mesh mesh;
            for (std::size_t i = 0; i < 4; ++i) {
                mesh[i] = placed({corners[(i + 1) % 4], corners[(i + 2) % 4], corners[(i + 3) % 4]},
                                 scale, scale * at);
            }
            return mesh;
        }
    }
}

class Leaks {
public:
    Leaks(double offset, std::size_t rays)
        : offset_(offset), counts_(512, std::uint32_t(rays / 512)) {
        Dice dice;
        for (std::size_t i = 0; i < counts_.size(); ++i) {
            const Mesh mesh = some_mesh(offset, dice);
            std::ranges::transform(mesh, triangles_.emplace_back().begin(), to_device);
        }
    }

    void measure(Sweep &sweep, const std::string &series, DeviceProgram &program) const {
        const auto leaks = program.run<std::uint32_t>("leak", counts_, triangles_);
        const double rays = std::accumulate(counts_.begin(), counts_.end(), 0.0);
        sweep.add(series, offset_, std::accumulate(leaks.begin(), leaks.end(), 0.0) / rays);
    }

private:
    double offset_;
    std::vector<std::uint32_t> counts_;
    std::vector<std::array<DeviceCorners, 4>> triangles_;
};

// From within a closed mesh at its edges and corners, ten million rays; a tenth on rusticl, which
// is slower. With math=mad PoCL contracts, and the two sides of an edge no longer work out one
// number; rusticl contracts nothing.
TEST_P(StabilityStage09Leaks, BetweenTwoTriangles) {
    Sweep sweep({.name = "triangle_leaks",
                 .kind = "triangle",
                 .title = "Between two triangles",
                 .x_label = "coordinates / size",
                 .y_label = "share of the rays at edges that slip through",
                 .limit = 1e-7,
                 .stated = "none at all"},
                GetParam());
    DeviceProgram program = build("leaf_triangles.cl", with_triangles(1));
    DeviceProgram wide = build("leaf_triangles.cl", with_triangles(4));
    DeviceProgram contracted = build("leaf_triangles.cl", with_triangles(1), {{"math", "mad"}});
    DeviceProgram moeller_trumbore =
        build("leaf_triangles.cl", with_triangles(1), {{"triangle", "moeller_trumbore"}});
    for (const double offset : {1.0, 10.0, 100.0, 1e3, 1e4}) {
        const Leaks many(offset, on_rusticl() ? 204'800 : 2'048'000);
        const Leaks few(offset, 204'800);
        many.measure(sweep, "woop", program);
        many.measure(sweep, "woop, each its axis", wide);
        few.measure(sweep, "woop, math=mad", contracted);
        few.measure(sweep, "moeller_trumbore", moeller_trumbore);
    }
    sweep.expect_holds("woop", 1e4);
    sweep.expect_holds("woop, each its axis", 1e4);
    sweep.expect_fails("moeller_trumbore", 1);
    if (!on_rusticl()) {
        sweep.expect_fails("woop, math=mad", 1);
    }
}

}  // namespace
}  // namespace stagelight::stability
