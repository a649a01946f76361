// SPDX-License-Identifier: MIT
#include <cmath>

#include "kernels/on_device.h"
#include "kernels/worst.h"
#include "reference/intersect.h"
#include "reference/scenes.h"

namespace stagelight {
namespace {

using glm::dvec3, glm::vec3, glm::vec4;
using reference::Dice;
using Wide = reference::Vec<long double>;  // the truth: float inputs are exact in it
constexpr float infinity = std::numeric_limits<float>::infinity();

using KernelsStage01Sphere = OnDevice;
INSTANTIATE_TEST_SUITE_P(On, KernelsStage01Sphere, each_device(), device_name);

// Rays, or lines: `ends` are directions or destinations.
struct Cases {
    std::vector<vec4> origins, ends, spheres;

    void add(const dvec3 &origin, const dvec3 &end, const dvec3 &center, double radius) {
        origins.emplace_back(vec3(origin), 0);
        ends.emplace_back(vec3(end), 0);
        spheres.emplace_back(vec3(center), radius);
    }
};

// Radii of a millionth to a million; from within and from up to a million radii away, aimed
// past the centre by up to 1.3 radii, a few the other way.
Cases random_rays() {
    Dice dice;
    Cases cases;
    for (int i = 0; i < 8192; ++i) {
        const double radius = std::pow(10, dice.between(-6, 6));
        const double away = i % 3 == 0 ? dice.between(0, 1) : std::pow(10, dice.between(0, 6));
        const dvec3 center = radius * dice.in_cube(100);
        const dvec3 to_origin = dice.direction();
        const dvec3 aside = glm::normalize(glm::cross(to_origin, dice.direction()));
        const dvec3 way = dice.between(0, 1.3) * aside - away * to_origin;
        cases.add(center + radius * away * to_origin, (i % 16 == 0 ? -1.0 : 1.0) * normalize(way),
                  center, radius);
    }
    return cases;
}

TEST_P(KernelsStage01Sphere, RaysMatchLongDouble) {
    const Cases cases = random_rays();
    const auto distances =
        build("primitives.cl").run<float>("ray_sphere", cases.origins, cases.ends, cases.spheres);
    Worst worst("distance to a sphere");
    for (std::size_t i = 0; i < distances.size(); ++i) {
        const Wide origin(cases.origins[i]), center(cases.spheres[i]);
        const Wide direction = glm::normalize(Wide(cases.ends[i]));
        const long double radius = cases.spheres[i].w;
        const long double away = glm::distance(origin, center);
        const Wide nearest = glm::dot(center - origin, direction) * direction;
        const long double aside = glm::distance(origin + nearest, center);
        // The centre is seen with a rounding of its distance, and from within a radius of the
        // wall's tangent no digit of the half chord is left.
        const double rounding = 2 * ulp * double(away);
        if (std::abs(aside - radius) < rounding + ulp * radius
            || std::abs(away - radius) < 2 * ulp * radius) {
            continue;
        }
        const double half_chord =
            double(std::sqrt(std::max(0.0L, (radius - aside) * (radius + aside))));
        const double tolerance =
            rounding + 2 * ulp * half_chord
            + (aside < radius ? double(rounding * aside + ulp * radius * radius) / half_chord : 0);
        const auto truth = reference::intersect_sphere({origin, direction}, center, radius);
        worst.compare(i, distances[i], double(truth.value_or(infinity)), tolerance);
    }
    worst.expect(7000);
}

TEST_P(KernelsStage01Sphere, NastyRaysHitWhereTheClosedFormSays) {
    struct Case {
        dvec3 origin, direction;
        float expected;
        const char *what;
    };
    const float above_1 = std::nextafter(1.0F, 2.0F);
    const std::vector<Case> list{
        {{0, 0, 5}, {0, 0, -1}, 4, "straight at it"},
        {{0, 0, 0}, {0, 1, 0}, 1, "from the centre"},
        {{0, 0, 0.5}, {0, 0, -1}, 1.5, "from inside, across"},
        {{0, 0, 0.5}, {0, 0, 1}, 0.5, "from inside, the near wall"},
        {{0, 0, 5}, {0, 0, 1}, infinity, "behind"},
        {{0, 0, 1}, {0, 0, 1}, infinity, "from the surface, outwards"},
        {{1, 0, 5}, {0, 0, -1}, 5, "a tangent touches"},
        {{above_1, 0, 5}, {0, 0, -1}, infinity, "just beside the tangent"},
        {{1, 0, 0}, {0, 0, 1}, infinity, "the tangent from where it touches"},
        {{0, 0, 1048576}, {0, 0, -1}, 1048575, "from a million radii"},
        {{2, 0, 0}, {0, 0, 0}, infinity, "no direction"},
        {{NAN, 0, 5}, {0, 0, -1}, infinity, "no place"},
        {{0, 0, 5}, {0, NAN, -1}, infinity, "a direction that is none"},
    };
    DeviceProgram program = build("primitives.cl");
    // Powers of two scale every rounding alike: the answer is the same to the bit.
    for (const double scale : {1.0, std::ldexp(1.0, -40), std::ldexp(1.0, 40)}) {
        Cases cases;
        for (const Case &it : list) {
            cases.add(scale * it.origin, it.direction, {0, 0, 0}, scale);
        }
        const auto distances =
            program.run<float>("ray_sphere", cases.origins, cases.ends, cases.spheres);
        for (std::size_t i = 0; i < list.size(); ++i) {
            EXPECT_EQ(distances[i], list[i].expected * static_cast<float>(scale))
                << list[i].what << ", radius " << scale;
        }
    }
}

// Both ends within some radii of the centre, or one a million radii away.
Cases random_lines() {
    Dice dice;
    Cases cases;
    for (int i = 0; i < 8192; ++i) {
        const double radius = std::pow(10, dice.between(-6, 6));
        const dvec3 center = radius * dice.in_cube(100);
        const double reach = i % 4 == 0 ? std::pow(10, dice.between(0, 6)) : 1.5;
        cases.add(center + radius * reach * dice.in_cube(1), center + radius * dice.in_cube(1.5),
                  center, radius);
    }
    return cases;
}

TEST_P(KernelsStage01Sphere, LinesMatchLongDouble) {
    const Cases cases = random_lines();
    const auto meets =
        build("primitives.cl").run<int>("line_sphere", cases.origins, cases.ends, cases.spheres);
    Worst worst("line meets sphere");
    for (std::size_t i = 0; i < meets.size(); ++i) {
        const reference::Line<long double> line{Wide(cases.origins[i]), Wide(cases.ends[i])};
        const Wide center(cases.spheres[i]);
        const long double radius = cases.spheres[i].w;
        const Wide direction = glm::normalize(line.destination - line.origin);
        const Wide to_center = center - line.origin;
        const long double aside =
            glm::length(to_center - glm::dot(to_center, direction) * direction);
        const auto near_surface = [&](long double away, long double size) {
            return std::abs(away - radius) < 2 * ulp * size;
        };
        if (!near_surface(glm::length(to_center), radius)
            && !near_surface(glm::distance(line.destination, center), radius)
            && !near_surface(aside, radius + glm::length(to_center))) {
            worst.compare(i, meets[i], reference::line_meets_sphere(line, center, radius), 0);
        }
    }
    worst.expect(8000);
}

TEST_P(KernelsStage01Sphere, NastyLinesMeetItOnlyBetweenTheirEnds) {
    struct Case {
        dvec3 origin, destination;
        int expected;
        const char *what;
    };
    const std::vector<Case> list{
        {{0, 0, 5}, {0, 0, -5}, 1, "through"},
        {{0, 0, 5}, {0, 0, 0}, 1, "to a light inside"},
        {{0, 0, 0}, {0, 5, 0}, 1, "out of it"},
        {{0, 0, 5}, {0, 0, 1}, 0, "to a light on its surface"},
        {{0, 0, 1}, {0, 0, 5}, 0, "from its surface, outwards"},
        {{0, 0, 1}, {0, 0, -5}, 1, "from its surface, through"},
        {{0, 0, 5}, {0, 0, 2}, 0, "ends before"},
        {{0, 0, -2}, {0, 0, -5}, 0, "starts beyond"},
        {{0, 0, 0.5}, {0, 0.5, -0.5}, 0, "both ends inside"},
        {{1.5, 0, 5}, {1.5, 0, -5}, 0, "passes by"},
        {{2, 0, 0}, {2, 0, 0}, 0, "no length, outside"},
        {{0.5, 0, 0}, {0.5, 0, 0}, 0, "no length, inside"},
        {{0, 0, 1048576}, {0, 0, -1048576}, 1, "a million radii long"},
        {{NAN, 0, 5}, {0, 0, -5}, 0, "no place"},
    };
    DeviceProgram program = build("primitives.cl");
    for (const double scale : {1.0, std::ldexp(1.0, -40), std::ldexp(1.0, 40)}) {
        Cases cases;
        for (const Case &it : list) {
            cases.add(scale * it.origin, scale * it.destination, {0, 0, 0}, scale);
        }
        const auto meets =
            program.run<int>("line_sphere", cases.origins, cases.ends, cases.spheres);
        for (std::size_t i = 0; i < list.size(); ++i) {
            EXPECT_EQ(meets[i], list[i].expected) << list[i].what << ", radius " << scale;
        }
    }
}

}  // namespace
}  // namespace stagelight
