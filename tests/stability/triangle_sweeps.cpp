// SPDX-License-Identifier: MIT
// Where the ways to intersect a triangle lose it. The truth is long double: float input is exact in
// it.
#include <cmath>
#include <numbers>
#include <optional>

#include "kernels/on_device.h"
#include "reference/scenes.h"
#include "stability/leaf_triangles.h"
#include "stability/sweep.h"

namespace stagelight::stability {
namespace {

using glm::dvec3, glm::vec3, glm::vec4;
using reference::Dice;

// A triangle with corners on the unit circle, of any orientation, none of its angles small.
Corners some_triangle(Dice &dice) {
    const dvec3 normal = dice.direction();
    const dvec3 right = glm::normalize(glm::cross(normal, dice.direction()));
    const dvec3 up = glm::cross(normal, right);
    Corners corners;
    for (std::size_t i = 0; i < 3; ++i) {
        const double angle = (2 * double(i) + dice.between(-0.5, 0.5)) * std::numbers::pi / 3;
        corners[i] = std::cos(angle) * right + std::sin(angle) * up;
    }
    return corners;
}

struct Cases {
    std::vector<double> x;
    std::vector<vec4> origins, directions;
    std::vector<DeviceCorners> triangles;

    // A ray from `distance` away to somewhere well inside, at 60 degrees or less to the normal.
    void add(double at, const Corners &corners, double distance, Dice &dice) {
        const double b = dice.between(0.15, 0.6);
        const double c = dice.between(0.15, 0.85 - b);
        const dvec3 target =
            corners[0] + b * (corners[1] - corners[0]) + c * (corners[2] - corners[0]);
        const dvec3 normal =
            glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
        dvec3 way;
        do {
            way = dice.direction();
        } while (std::abs(glm::dot(way, normal)) < 0.5);
        const dvec3 origin(vec3(target + distance * way));
        x.push_back(at);
        origins.emplace_back(vec3(origin), 0);
        directions.emplace_back(vec3(glm::normalize(target - origin)), 0);
        triangles.push_back(to_device(corners));
    }
};

// Along the normal from each edge to a point of the plane, the least of the three.
long double depth_inside(const DeviceCorners &triangle, const Exact &point) {
    const Exact normal = glm::cross(corner(triangle, 1) - corner(triangle, 0),
                                    corner(triangle, 2) - corner(triangle, 0));
    long double least = INFINITY;
    for (std::size_t i = 0; i < 3; ++i) {
        const Exact from = corner(triangle, i);
        const Exact edge = corner(triangle, (i + 1) % 3) - from;
        const Exact inwards = glm::normalize(glm::cross(normal, edge));
        least = std::min(least, glm::dot(inwards, point - from));
    }
    return least;
}

// How far off the hit is, by the method's distance or by its weights, in distances; 1 for a miss.
// Nothing where the ray passes an edge so closely that rounding the ways to the corners decides.
std::optional<double> error_of(const Cases &cases, std::size_t i, const vec4 &hit) {
    const DeviceCorners &triangle = cases.triangles[i];
    const Exact origin(cases.origins[i]), direction(cases.directions[i]);
    const Exact to_b = corner(triangle, 1) - corner(triangle, 0);
    const Exact to_c = corner(triangle, 2) - corner(triangle, 0);
    const Exact normal = glm::cross(to_b, to_c);
    const long double distance =
        glm::dot(normal, corner(triangle, 0) - origin) / glm::dot(normal, direction);
    const Exact point = origin + distance * direction;
    if (!(depth_inside(triangle, point) > 3e-7L * distance)) {
        return {};
    }
    if (!std::isfinite(hit.x)) {
        return 1;
    }
    const Exact by_weights =
        corner(triangle, 0) + Exact::value_type(hit.y) * to_b + Exact::value_type(hit.z) * to_c;
    return double(std::max(std::abs(hit.x - distance), glm::distance(by_weights, point))
                  / distance);
}

void measure(Sweep &sweep, const std::string &series, DeviceProgram program, const Cases &cases) {
    const auto hits = program.run<vec4>("hit", cases.origins, cases.directions, cases.triangles);
    std::size_t counted = 0;
    for (std::size_t i = 0; i < hits.size(); ++i) {
        if (const auto error = error_of(cases, i, hits[i])) {
            sweep.add(series, cases.x[i], *error);
            ++counted;
        }
    }
    EXPECT_GT(counted, 9 * hits.size() / 10);
}

class StabilityStage09Triangle : public OnDevice {
protected:
    static void measure_all(Sweep &sweep, const Cases &cases) {
        for (const char *method : {"woop", "moeller_trumbore", "threshold"}) {
            measure(sweep, method,
                    build("leaf_triangles.cl", with_triangles(1), {{"triangle", method}}), cases);
        }
        measure(sweep, "woop, each its axis", build("leaf_triangles.cl", with_triangles(4)), cases);
    }
};
INSTANTIATE_TEST_SUITE_P(On, StabilityStage09Triangle, each_device(), device_name);

Question about(const char *name, const char *title, const char *x_label, const char *stated) {
    return {.name = name,
            .kind = "triangle",
            .title = title,
            .x_label = x_label,
            .y_label = "error of the hit / distance, 1 for a miss",
            .limit = 1e-5,
            .stated = stated};
}

// From a size of 1 on.
Cases of_size(double to) {
    Dice dice;
    Cases cases;
    for (int step = 0; step <= 12; ++step) {
        const double size = std::pow(to, step / 12.0);
        for (int i = 0; i < 256; ++i) {
            cases.add(std::max(size, 1 / size), placed(some_triangle(dice), size, dvec3(0)),
                      4 * size, dice);
        }
    }
    return cases;
}

TEST_P(StabilityStage09Triangle, Small) {
    Sweep sweep(about("triangle_small", "Small triangles", "1 / radius", "to a radius of 1e-6"),
                GetParam());
    measure_all(sweep, of_size(1e-6));
    sweep.expect_holds("woop", 1e6);
    sweep.expect_holds("woop, each its axis", 1e6);
    sweep.expect_fails("threshold", 1e3);
}

TEST_P(StabilityStage09Triangle, Large) {
    Sweep sweep(about("triangle_large", "Large triangles", "radius", "to a radius of 1e6"),
                GetParam());
    measure_all(sweep, of_size(1e6));
    sweep.expect_holds("woop", 1e6);
    sweep.expect_holds("woop, each its axis", 1e6);
}

TEST_P(StabilityStage09Triangle, Slivers) {
    Dice dice;
    Cases cases;
    for (int step = 0; step <= 12; ++step) {
        const double aspect = std::pow(10, step / 2.0);
        for (int i = 0; i < 256; ++i) {
            const Corners whole = some_triangle(dice);
            const dvec3 foot = glm::mix(whole[0], whole[1], dice.between(0.2, 0.8));
            const Corners sliver = {whole[0], whole[1], foot + (whole[2] - foot) / aspect};
            cases.add(aspect, placed(sliver, 1, dice.in_cube(0.5)), 1, dice);
        }
    }
    Sweep sweep(about("triangle_slivers", "Slivers", "length / width", "to a length of 100 widths"),
                GetParam());
    measure_all(sweep, cases);
    sweep.expect_holds("woop", 100);
    sweep.expect_holds("woop, each its axis", 100);
    sweep.expect_fails("moeller_trumbore", 100);
    sweep.expect_fails("woop", 1e4);
}

TEST_P(StabilityStage09Triangle, FarFromTheOrigin) {
    Dice dice;
    Cases cases;
    for (int step = 0; step <= 12; ++step) {
        const double offset = std::pow(10, step / 2.0);
        for (int i = 0; i < 256; ++i) {
            cases.add(offset, placed(some_triangle(dice), 1, offset * dice.direction()), 4, dice);
        }
    }
    Sweep sweep(about("triangle_offset", "Triangles far from the origin", "coordinates / radius",
                      "to coordinates of 1e6 radii"),
                GetParam());
    measure_all(sweep, cases);
    sweep.expect_holds("woop", 1e6);
    sweep.expect_holds("woop, each its axis", 1e6);
}

}  // namespace
}  // namespace stagelight::stability
