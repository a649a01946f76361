// SPDX-License-Identifier: MIT
#include <cmath>

#include "kernels/on_device.h"
#include "kernels/worst.h"
#include "reference/scenes.h"

namespace stagelight {
namespace {

using glm::dvec3, glm::vec3, glm::vec4;
using reference::Dice;
constexpr float infinity = std::numeric_limits<float>::infinity();

using KernelsStage01Plane = OnDevice;
INSTANTIATE_TEST_SUITE_P(On, KernelsStage01Plane, each_device(), device_name);

// Rays, or lines: `ends` are directions or destinations.
struct Cases {
    std::vector<vec4> origins, ends, planes;

    void add(const dvec3 &origin, const dvec3 &end, const dvec3 &normal, double offset) {
        origins.emplace_back(vec3(origin), 0);
        ends.emplace_back(vec3(end), 0);
        planes.emplace_back(vec3(normal), offset);
    }
};

// A sum of products, exact in double for floats, and what its rounding is in proportion to.
struct Sum {
    double value, size;
};

Sum dot(const vec4 &a, const vec4 &b, double less = 0) {
    const dvec3 products = dvec3(a) * dvec3(b);
    return {products.x + products.y + products.z - less,
            std::abs(products.x) + std::abs(products.y) + std::abs(products.z) + std::abs(less)};
}

// From a millionth to a million across, every fourth ray all but along the plane.
Cases random_rays() {
    Dice dice;
    Cases cases;
    for (int i = 0; i < 8192; ++i) {
        const double scale = std::pow(10, dice.between(-6, 6));
        const dvec3 normal = dice.direction();
        const dvec3 along = glm::normalize(glm::cross(normal, dice.direction()));
        const dvec3 steep = dice.direction();
        const double tilt = std::pow(10, dice.between(-7, 0)) * (i % 8 == 0 ? -1 : 1);
        cases.add(scale * dice.in_cube(1), i % 4 == 0 ? normalize(along + tilt * normal) : steep,
                  normal, scale * dice.between(-1, 1));
    }
    return cases;
}

TEST_P(KernelsStage01Plane, RaysMatchDouble) {
    const Cases cases = random_rays();
    const auto distances =
        build("primitives.cl").run<float>("ray_plane", cases.origins, cases.ends, cases.planes);
    Worst worst("distance to a plane");
    for (std::size_t i = 0; i < distances.size(); ++i) {
        const Sum height = dot(cases.planes[i], cases.origins[i], cases.planes[i].w);
        const Sum slope = dot(cases.planes[i], cases.ends[i]);
        const double truth = -height.value / slope.value;
        // Three roundings a sum, at most: below them a sign means nothing.
        if (std::abs(height.value) < 2 * ulp * height.size
            || std::abs(slope.value) < 2 * ulp * slope.size) {
            continue;
        }
        const double tolerance = 2 * ulp * (height.size + std::abs(truth) * slope.size)
                                 / (std::abs(slope.value) - 2 * ulp * slope.size);
        worst.compare(i, distances[i], truth > 0 ? truth : infinity, tolerance);
    }
    worst.expect(8000);
}

TEST_P(KernelsStage01Plane, NastyRaysHitWhereTheClosedFormSays) {
    struct Case {
        dvec3 origin, direction;
        double offset;
        float expected;
        const char *what;
    };
    const std::vector<Case> list{
        {{0, 4, 0}, {0, -1, 0}, -2, 6, "straight down"},
        {{0, -4, 0}, {0, 1, 0}, -2, 2, "from below"},
        {{0, 4, 0}, {0, 1, 0}, -2, infinity, "behind"},
        {{0, 4, 0}, {1, 0, 0}, -2, infinity, "along it"},
        {{0, -4, 0}, {1, 0, 0}, -2, infinity, "along it, below"},
        {{5, -2, 1}, {1, 0, 0}, -2, infinity, "in it"},
        {{5, -2, 1}, {0, -1, 0}, -2, infinity, "from it"},
        {{0, 0, 0}, {0, -1, 0}, -1e18, 1e18F, "at the largest distance of a scene file"},
        {{0, 1e18, 0}, {0, -1, 0}, 1e18, infinity, "from it, as far away"},
        {{0, 1, 0}, {1, -1e-30, 0}, 0, 1e30F, "all but along it"},
        {{NAN, NAN, 0}, {0, -1, 0}, 0, infinity, "no place"},
    };
    Cases cases;
    for (const Case &it : list) {
        cases.add(it.origin, it.direction, {0, 1, 0}, it.offset);
    }
    const auto distances =
        build("primitives.cl").run<float>("ray_plane", cases.origins, cases.ends, cases.planes);
    for (std::size_t i = 0; i < list.size(); ++i) {
        EXPECT_FLOAT_EQ(distances[i], list[i].expected) << list[i].what;
    }
}

TEST_P(KernelsStage01Plane, LinesMatchDouble) {
    Dice dice;
    Cases cases;
    for (int i = 0; i < 8192; ++i) {
        const double scale = std::pow(10, dice.between(-6, 6));
        const dvec3 origin = dice.in_cube(1), destination = dice.in_cube(1);
        cases.add(scale * origin, scale * destination, dice.direction(),
                  scale * dice.between(-0.5, 0.5));
    }
    const auto meets =
        build("primitives.cl").run<int>("line_plane", cases.origins, cases.ends, cases.planes);
    Worst worst("line meets plane");
    for (std::size_t i = 0; i < meets.size(); ++i) {
        const Sum before = dot(cases.planes[i], cases.origins[i], cases.planes[i].w);
        const Sum after = dot(cases.planes[i], cases.ends[i], cases.planes[i].w);
        if (std::abs(before.value) > 2 * ulp * before.size
            && std::abs(after.value) > 2 * ulp * after.size) {
            worst.compare(i, meets[i], before.value * after.value < 0, 0);
        }
    }
    worst.expect(8000);
}

TEST_P(KernelsStage01Plane, NastyLinesMeetItOnlyBetweenTheirEnds) {
    struct Case {
        dvec3 origin, destination;
        double offset;
        int expected;
        const char *what;
    };
    const std::vector<Case> list{
        {{0, 1, 0}, {5, -3, 0}, -2, 1, "through"},
        {{5, -3, 0}, {0, 1, 0}, -2, 1, "through, from below"},
        {{0, 1, 0}, {5, -1.5, 0}, -2, 0, "ends before"},
        {{0, -2.5, 0}, {5, -3, 0}, -2, 0, "starts beyond"},
        {{0, 1, 0}, {5, 1, 0}, -2, 0, "along it"},
        {{0, -2, 0}, {5, -2, 0}, -2, 0, "in it"},
        {{0, 1, 0}, {5, -2, 0}, -2, 0, "to a light on it"},
        {{0, -5, 0}, {5, -2, 0}, -2, 0, "to a light on it, from below"},
        {{5, -2, 0}, {0, 1, 0}, -2, 0, "from it"},
        {{5, -2, 0}, {0, -5, 0}, -2, 0, "from it, downwards"},
        {{0, 1e-30, 0}, {0, -1e-30, 0}, 0, 1, "a line so short that the product of its ends is 0"},
        {{NAN, NAN, 0}, {0, -1, 0}, -2, 0, "no place"},
    };
    Cases cases;
    for (const Case &it : list) {
        cases.add(it.origin, it.destination, {0, 1, 0}, it.offset);
    }
    const auto meets =
        build("primitives.cl").run<int>("line_plane", cases.origins, cases.ends, cases.planes);
    for (std::size_t i = 0; i < list.size(); ++i) {
        EXPECT_EQ(meets[i], list[i].expected) << list[i].what;
    }
}

}  // namespace
}  // namespace stagelight
