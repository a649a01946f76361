// SPDX-License-Identifier: MIT
// Rays that meet a triangle, long double says, and are said not to be in the box around it: the
// triangle has a hole there. Most are aimed where it touches the box. And rays that are not of
// finite numbers, which must change nothing for those beside them.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "kernels/on_device.h"
#include "reference/intersect.h"
#include "reference/scenes.h"
#include "stability/leaf_triangles.h"
#include "stability/sweep.h"

namespace stagelight::stability {
namespace {

using glm::dvec3, glm::ivec4, glm::vec3, glm::vec4;
using reference::Dice;

using device::BvhNode;

// As common/device/bvh.cpp makes it; all children but the first are empty.
BvhNode node_around(const Corners &corners, bool padded) {
    const vec3 low(glm::min(corners[0], glm::min(corners[1], corners[2])));
    const vec3 high(glm::max(corners[0], glm::max(corners[1], corners[2])));
    const vec3 largest = glm::max(glm::abs(low), glm::abs(high));
    const float padding = padded ? SLAB_PADDING * std::max({largest.x, largest.y, largest.z}) : 0;
    BvhNode node{};
    for (int axis = 0; axis < 3; ++axis) {
        node.planes[axis].s[0] = low[axis] - padding;
        node.planes[axis + 3].s[0] = high[axis] + padding;
    }
    return node;
}

struct Cases {
    std::vector<double> x;
    std::vector<Corners> triangles;
    std::vector<vec4> origins, directions;

    // Left out if it misses.
    void add(double at, const Corners &triangle, const dvec3 &origin, const dvec3 &direction) {
        const vec3 from(origin), along(direction);
        const reference::Ray<long double> ray{Exact(from), Exact(along)};
        if (reference::intersect_triangle(
                ray, {Exact(triangle[0]), Exact(triangle[1]), Exact(triangle[2])})) {
            x.push_back(at);
            triangles.push_back(triangle);
            origins.emplace_back(from, 0);
            directions.emplace_back(along, 0);
        }
    }
};

// The share of the rays that are said not to be in the box.
void measure(Sweep &sweep, const std::string &series, bool padded, DeviceProgram program,
             const Cases &cases) {
    std::vector<BvhNode> nodes;
    for (const Corners &triangle : cases.triangles) {
        nodes.push_back(node_around(triangle, padded));
    }
    const auto entered = program.run<int>("enter_all_ways", cases.origins, cases.directions, nodes);
    std::map<double, std::pair<double, double>> lost;
    for (std::size_t i = 0; i < entered.size(); ++i) {
        auto &[count, all] = lost[cases.x[i]];
        count += entered[i] == 0 ? 1 : 0;
        all += 1;
    }
    for (const auto &[x, counts] : lost) {
        EXPECT_GT(counts.second, 500) << x;
        sweep.add(series, x, counts.first / counts.second);
    }
}

SceneNeeds with_tree(int width) {
    return {{"HAS_TRIANGLES", 1}, {"HAS_TREE", 1}, {"WIDTH", width}, {"BVH_STACK_SIZE", 1}};
}

Question about(const char *name, const char *title, const char *x_label, const char *stated) {
    return {.name = name,
            .kind = "box",
            .title = title,
            .x_label = x_label,
            .y_label = "share of the hits that are lost",
            .limit = 1e-4,
            .stated = stated};
}

class StabilityStage09Box : public OnDevice {
protected:
    static void measure_all(Sweep &sweep, const Cases &cases) {
        for (const char *method : {"robust", "ordered"}) {
            measure(sweep, method, method == std::string("robust"),
                    build("tree.cl", with_tree(1), {{"box", method}}), cases);
        }
        if (!on_rusticl()) {  // which takes three seconds to build it
            measure(sweep, "robust, width=4", true, build("packet_boxes_beside.cl", with_tree(4)),
                    cases);
        }
    }

    static void expect_padding_counts(Sweep &sweep, double last) {
        sweep.expect_holds("robust", last);
        if (!on_rusticl()) {
            sweep.expect_holds("robust, width=4", last);
        }
        sweep.expect_fails("ordered", 1);
    }
};

INSTANTIATE_TEST_SUITE_P(On, StabilityStage09Box, each_device(), device_name);

// Seen along the axis, two of its sides are those of the box; which is flat where there is no tilt.
Corners right_triangle(const dvec3 &at, int axis, double tilt, Dice &dice) {
    Corners corners = {at, at, at};
    for (const int side : {1, 2}) {
        corners[std::size_t(side)][(axis + side) % 3] += dice.between(-1, 1);
        corners[std::size_t(side)][axis] += tilt * dice.between(-1, 1);
    }
    return placed(corners, 1, dvec3(0));
}

// Inside, on a side or at a corner.
dvec3 somewhere_on(const Corners &corners, Dice &dice) {
    const double b = dice.between(-0.5, 1), c = dice.between(-0.5, 1);
    const dvec3 weights = glm::max(dvec3(1 - b - c, b, c), dvec3(0));
    return (weights.x * corners[0] + weights.y * corners[1] + weights.z * corners[2])
           / (weights.x + weights.y + weights.z);
}

TEST_P(StabilityStage09Box, FarFromTheOrigin) {
    Dice dice;
    Cases cases;
    for (int power = 0; power <= 6; ++power) {
        const double offset = std::pow(10, power);
        for (int i = 0; i < 4096; ++i) {
            const dvec3 at = offset * dice.direction();
            const Corners corners =
                i % 2 == 0 ? right_triangle(at, i / 2 % 3, 0, dice)
                           : placed({dice.in_cube(1), dice.in_cube(1), dice.in_cube(1)}, 1, at);
            const dvec3 origin(vec3(at + 4.0 * dice.direction()));
            cases.add(offset, corners, origin,
                      glm::normalize(somewhere_on(corners, dice) - origin));
        }
    }
    Sweep sweep(about("box_offset", "Boxes far from the origin", "coordinates / size",
                      "to coordinates of 1e6 sizes"),
                GetParam());
    measure_all(sweep, cases);
    expect_padding_counts(sweep, 1e6);
}

// Along an axis but for a little, from the planes of the box: its sides are where the triangle's
// are.
TEST_P(StabilityStage09Box, NearlyAlongAnAxis) {
    Dice dice;
    Cases cases;
    for (int power = 0; power <= 46; power += 2) {
        const double little = power < 46 ? std::pow(10, -power) : 0;
        for (int i = 0; i < 4096; ++i) {
            const int axis = i % 3;
            const Corners corners = right_triangle(dice.in_cube(2), axis, i / 8 % 2, dice);
            dvec3 direction(0);
            direction[axis] = i % 2 == 0 ? 1 : -1;
            direction[(axis + 1) % 3] = i / 2 % 2 == 0 ? little : -little;
            direction[(axis + 2) % 3] = i / 4 % 2 == 0 ? 0.0 : -little;
            const dvec3 target = somewhere_on(corners, dice);
            cases.add(std::pow(10, power), corners, target - dice.between(1, 4) * direction,
                      direction);
        }
    }
    Sweep sweep(about("box_along_axis", "Rays nearly along an axis",
                      "1 / the smallest part of the direction, 1e46 for 0", "for every direction"),
                GetParam());
    measure_all(sweep, cases);
    expect_padding_counts(sweep, 1e46);
}

// Rays that hit a triangle, which is in the first of four boxes, and miss the others. Each has
// `count` others beside it, from the same place.
struct Neighbours {
    std::vector<double> x;
    std::vector<vec4> origins, directions, others;
    std::vector<int> counts;
    std::vector<BvhNode> nodes;
    std::vector<DeviceCorners> triangles;
    Dice dice;

    // Of the others, one or more parts are as large as that.
    void add(int count, float large) {
        const Corners corners =
            placed({dice.in_cube(1), dice.in_cube(1), dice.in_cube(1)}, 1, dvec3(0));
        const dvec3 weights(dice.between(1, 2), dice.between(1, 2), dice.between(1, 2));
        const dvec3 target =
            (weights.x * corners[0] + weights.y * corners[1] + weights.z * corners[2])
            / (weights.x + weights.y + weights.z);
        const vec3 origin(target + 4.0 * dice.direction());
        const vec3 direction(glm::normalize(target - dvec3(origin)));
        const reference::Ray<long double> ray{Exact(origin), Exact(direction)};
        if (!reference::intersect_triangle(
                ray, {Exact(corners[0]), Exact(corners[1]), Exact(corners[2])})) {
            return;
        }
        vec3 other(dice.direction());
        const auto parts = unsigned(x.size() % 7 + 1);  // each set of them
        for (int axis = 0; axis < 3; ++axis) {
            if ((parts >> axis & 1) != 0) {
                other[axis] = dice.between(-1, 1) < 0 ? -large : large;
            }
        }
        BvhNode node = node_around(corners, true);
        for (std::size_t child = 1; child < 4; ++child) {
            const dvec3 behind = dvec3(origin) - 3.0 * dvec3(direction) + dice.in_cube(1);
            for (int axis = 0; axis < 3; ++axis) {
                node.planes[axis].s[child] = float(behind[axis] - 0.1);
                node.planes[axis + 3].s[child] = float(behind[axis] + 0.1);
            }
        }
        x.push_back(std::max(count, 1));
        origins.emplace_back(origin, 0);
        directions.emplace_back(count > 0 ? direction : other, 0);
        others.emplace_back(other, 0);
        counts.push_back(count);
        nodes.push_back(node);
        triangles.push_back(to_device(corners));
    }

    std::vector<ivec4> ask(DeviceProgram program) const {
        return program.run<ivec4>("enter_beside", origins, directions, others, counts, nodes,
                                  triangles);
    }
};

using StabilityStage09NotFinite = StabilityStage09Box;
INSTANTIATE_TEST_SUITE_P(On, StabilityStage09NotFinite, each_device(), device_name);

// A direction with an infinite part has no length to divide by: its ray hits nothing, and what the
// others are told is what they are told without it. The largest finite number is a direction like
// any other: its ray counts, and the beam becomes as wide as all space.
TEST_P(StabilityStage09NotFinite, BesideOthers) {
    Sweep sweep({.name = "box_infinite",
                 .kind = "box",
                 .title = "Rays of infinite direction among others",
                 .x_label = "how many of them beside a ray",
                 .y_label = "share of the rays that they disturb",
                 .limit = 1e-4,
                 .stated = "any number of them"},
                GetParam());
    const auto measure_beside = [&](const std::string &series, int width, const char *method,
                                    float large) {
        const int rays = width == 1 ? 1 : 4 * width;
        Neighbours cases;
        for (int count = rays == 1 ? 0 : 1; count < rays; count = 2 * count + 1) {
            for (int i = 0; i < 1024; ++i) {
                cases.add(count, large);
            }
        }
        const auto told = cases.ask(build(width == 1 ? "tree.cl" : "packet_boxes_beside.cl",
                                          with_tree(width), {{"box", method}}));
        std::map<double, std::pair<double, double>> disturbed;
        for (std::size_t i = 0; i < told.size(); ++i) {
            const bool right = cases.counts[i] == 0
                                   ? told[i].x == 0
                                   : told[i].x != 0 && told[i].y == 0 && told[i].z == 0;
            auto &[wrong, all] = disturbed[cases.x[i]];
            wrong += right ? 0 : 1;
            all += 1;
        }
        for (const auto &[x, counts] : disturbed) {
            EXPECT_GT(counts.second, 500) << x;
            sweep.add(series, x, counts.first / counts.second);
        }
    };
    for (const char *method : {"robust", "ordered"}) {
        measure_beside(std::string(method) + ", alone", 1, method, INFINITY);
        sweep.expect_holds(std::string(method) + ", alone", 1);
    }
    if (on_rusticl()) {  // which takes three seconds and more to build what is wider
        return;
    }
    for (const int width : {4, 8, 16}) {
        const std::string series = "robust, width=" + std::to_string(width);
        measure_beside(series, width, "robust", INFINITY);
        sweep.expect_holds(series, 4 * width - 1);
    }
    measure_beside("ordered, width=4", 4, "ordered", INFINITY);
    sweep.expect_holds("ordered, width=4", 15);
    measure_beside("3e38 for infinity, width=4", 4, "robust", 3e38F);
    sweep.expect_fails("3e38 for infinity, width=4", 1);
}

}  // namespace
}  // namespace stagelight::stability
