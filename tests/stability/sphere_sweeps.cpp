// SPDX-License-Identifier: MIT
// Where the ways to intersect a sphere lose it. The truth is long double: float input is exact in
// it.
#include <cmath>

#include "kernels/on_device.h"
#include "reference/intersect.h"
#include "reference/scenes.h"
#include "stability/sweep.h"

namespace stagelight::stability {
namespace {

using glm::dvec3, glm::vec3, glm::vec4;
using reference::Dice;
using Exact = glm::vec<3, long double>;

const char *const methods[] = {"haines", "geometric", "textbook"};

struct Cases {
    std::vector<double> x;
    std::vector<vec4> origins, directions, spheres;

    void add(double at, const dvec3 &origin, const dvec3 &towards, const dvec3 &center,
             double radius) {
        x.push_back(at);
        origins.emplace_back(vec3(origin), 0);
        directions.emplace_back(vec3(glm::normalize(towards - dvec3(vec3(origin)))), 0);
        spheres.emplace_back(vec3(center), radius);
    }
};

// To where the ray enters the sphere, or leaves it from inside; infinity for a miss. `direction` is
// taken for what it is, which float has not quite of unit length.
long double true_distance(const vec4 &origin, const vec4 &direction, const vec4 &sphere) {
    const Exact to_center = Exact(sphere) - Exact(origin);
    const long double length = glm::length(Exact(direction));
    const Exact along = Exact(direction) / length;
    const long double nearest = glm::dot(to_center, along);
    const Exact aside = to_center - nearest * along;
    const long double radius = sphere.w;
    const long double half_squared = radius * radius - glm::dot(aside, aside);
    if (half_squared < 0) {
        return INFINITY;
    }
    const long double half = std::sqrt(half_squared);
    const bool inside = glm::dot(to_center, to_center) < radius * radius;
    const long double distance = inside ? nearest + half : nearest - half;
    return distance > 0 ? distance / length : INFINITY;
}

// error() where both are hits, 1 where only one is.
double error_of(double distance, long double truth, auto error) {
    const bool hits = std::isfinite(distance), should_hit = std::isfinite(truth);
    return hits && should_hit ? double(error()) : hits == should_hit ? 0 : 1;
}

long double to_distance(float distance, long double truth, const vec4 & /*sphere*/) {
    return std::abs(distance - truth) / truth;
}

long double to_radius(float distance, long double truth, const vec4 &sphere) {
    return std::abs(distance - truth) / sphere.w;
}

class StabilityStage09Sphere : public OnDevice {
protected:
    // Every method's worst error_of at each x, by error(distance, truth, sphere).
    template <typename Error> static void measure(Sweep &sweep, const Cases &cases, Error error) {
        const auto add = [&](const char *series, const std::vector<float> &distances) {
            for (std::size_t i = 0; i < distances.size(); ++i) {
                const long double truth =
                    true_distance(cases.origins[i], cases.directions[i], cases.spheres[i]);
                sweep.add(series, cases.x[i], error_of(distances[i], truth, [&] {
                              return error(distances[i], truth, cases.spheres[i]);
                          }));
            }
        };
        for (const char *method : methods) {
            add(method,
                build("primitives.cl", {}, {{"sphere", method}})
                    .run<float>("ray_sphere", cases.origins, cases.directions, cases.spheres));
        }
        add("haines, width=4",
            build("packet_spheres.cl", {{"WIDTH", 4}})
                .run<float>("distances", cases.origins, cases.directions, cases.spheres));
    }

    // That which is poor in float. Built for double, the kernels take and give it; directions are
    // of unit length in double then.
    static void add_in_double(Sweep &sweep, const Cases &cases) {
        using glm::dvec4;
        const std::vector<dvec4> origins(cases.origins.begin(), cases.origins.end());
        const std::vector<dvec4> spheres(cases.spheres.begin(), cases.spheres.end());
        std::vector<dvec4> directions;
        for (const vec4 &direction : cases.directions) {
            directions.push_back(glm::normalize(dvec4(direction)));
        }
        const auto distances =
            build("primitives.cl", {}, {{"sphere", "textbook"}, {"math", "fp64"}})
                .run<double>("ray_sphere", origins, directions, spheres);
        for (std::size_t i = 0; i < distances.size(); ++i) {
            const long double truth =
                true_distance(cases.origins[i], cases.directions[i], cases.spheres[i])
                * glm::length(Exact(cases.directions[i]));
            sweep.add("textbook, fp64", cases.x[i], error_of(distances[i], truth, [&] {
                          return std::abs(distances[i] - truth) / truth;
                      }));
        }
    }
};
INSTANTIATE_TEST_SUITE_P(On, StabilityStage09Sphere, each_device(), device_name);

TEST_P(StabilityStage09Sphere, FarAway) {
    Dice dice;
    Cases cases;
    for (int power = 0; power <= 28; ++power) {
        const double distance = std::pow(10, power / 4.0);
        for (int i = 0; i < 256; ++i) {
            const dvec3 way = dice.direction();
            const dvec3 aside =
                dice.between(0, 0.9) * glm::normalize(glm::cross(way, dice.direction()));
            cases.add(distance, {0, 0, 0}, (1 + distance) * way + aside, (1 + distance) * way, 1);
        }
    }
    Sweep sweep({.name = "sphere_distance",
                 .kind = "sphere",
                 .title = "Spheres far away",
                 .x_label = "distance / radii",
                 .y_label = "relative error of the distance",
                 .limit = 1e-5,
                 .stated = "to 10 million radii away; to 1 million without a fused multiply-add"},
                GetParam());
    measure(sweep, cases, to_distance);
    if (has_extension(device(), "cl_khr_fp64")) {
        add_in_double(sweep, cases);
        sweep.expect_holds("textbook, fp64", 1e7);
    }
    for (const char *series : {"haines", "haines, width=4"}) {
        sweep.expect_holds(series, on_rusticl() ? 1e6 : 1e7);  // it has no fused multiply-add
    }
    sweep.expect_fails("textbook", 1e3);
    sweep.expect_fails("geometric", 1e7);
}

// From one radius off the surface, a radius or so from the scene's origin.
Cases of_size(double largest) {
    Dice dice;
    Cases cases;
    for (int step = 0; step <= 14; ++step) {
        const double radius = std::pow(largest, step / 14.0);
        for (int i = 0; i < 256; ++i) {
            const dvec3 center = radius * dice.in_cube(1);
            const dvec3 target = center + 0.7 * radius * dice.direction();
            cases.add(std::max(radius, 1 / radius), center + 2 * radius * dice.direction(), target,
                      center, radius);
        }
    }
    return cases;
}

TEST_P(StabilityStage09Sphere, Small) {
    Sweep sweep({.name = "sphere_small",
                 .kind = "sphere",
                 .title = "Small spheres",
                 .x_label = "1 / radius",
                 .y_label = "relative error of the distance",
                 .limit = 1e-5,
                 .stated = "to a radius of 1e-6"},
                GetParam());
    const Cases cases = of_size(1e-6);
    measure(sweep, cases, to_distance);
    for (const char *series : {"haines", "haines, width=4"}) {
        sweep.expect_holds(series, cases.x.back());
    }
}

TEST_P(StabilityStage09Sphere, Large) {
    Sweep sweep({.name = "sphere_large",
                 .kind = "sphere",
                 .title = "Large spheres",
                 .x_label = "radius",
                 .y_label = "relative error of the distance",
                 .limit = 1e-5,
                 .stated = "to a radius of 1e7"},
                GetParam());
    const Cases cases = of_size(1e7);
    measure(sweep, cases, to_distance);
    for (const char *series : {"haines", "haines, width=4"}) {
        sweep.expect_holds(series, cases.x.back());
    }
}

// From one unit off the surface, inwards at 60 degrees or less to the normal. The height comes
// from the difference of two large squares, whose roundings grow as the radius over it.
TEST_P(StabilityStage09Sphere, Ground) {
    Dice dice;
    Cases cases;
    for (int step = 0; step <= 14; ++step) {
        const double radius = std::pow(10, step / 2.0);
        for (int i = 0; i < 256; ++i) {
            const dvec3 down = dice.direction();
            const dvec3 aside = glm::normalize(glm::cross(down, dice.direction()));
            const double angle = dice.between(0, std::numbers::pi / 3);
            cases.add(radius, {0, 0, 0}, std::cos(angle) * down + std::sin(angle) * aside,
                      (1 + radius) * down, radius);
        }
    }
    Sweep sweep({.name = "sphere_ground",
                 .kind = "sphere",
                 .title = "Spheres as the ground",
                 .x_label = "radius / height over the surface",
                 .y_label = "relative error of the distance",
                 .limit = 1e-3,
                 .stated = "to a radius of 1e4 heights"},
                GetParam());
    measure(sweep, cases, to_distance);
    for (const char *series : {"haines", "haines, width=4"}) {
        sweep.expect_holds(series, 1e4);
    }
    sweep.expect_fails("haines", 1e5);
}

// From 30 radii away, past the sphere or into it by a small part of its radius.
TEST_P(StabilityStage09Sphere, Tangent) {
    Dice dice;
    Cases cases;
    for (int step = 2; step <= 16; ++step) {
        const double part = std::pow(10, -step / 2.0);
        for (int i = 0; i < 512; ++i) {
            const dvec3 way = dice.direction();
            const dvec3 aside = glm::normalize(glm::cross(way, dice.direction()));
            const double impact = i % 2 == 0 ? 1 + part : 1 - part;
            cases.add(std::pow(10, step / 2.0), {0, 0, 0}, 30.0 * way, 30.0 * way - impact * aside,
                      1);
        }
    }
    Sweep sweep({.name = "sphere_tangent",
                 .kind = "sphere",
                 .title = "Rays that graze a sphere",
                 .x_label = "radius / distance from the tangent",
                 .y_label = "1 where hit and miss are confused",
                 .limit = 0.5,
                 .stated = "to three millionths of the radius"},
                GetParam());
    measure(sweep, cases, [](auto...) { return 0; });
    for (const char *series : {"haines", "haines, width=4"}) {
        sweep.expect_holds(series, std::pow(10, 5.5));
    }
    sweep.expect_fails("haines", 1e7);  // the distance to it has no such digits
    sweep.expect_fails("textbook", 1e4);
}

// From just off the surface, on either side of it, inwards at 60 degrees or less to the normal.
TEST_P(StabilityStage09Sphere, FromTheSurface) {
    Dice dice;
    Cases cases;
    for (int step = 2; step <= 16; ++step) {
        const double part = std::pow(10, -step / 2.0);
        for (int i = 0; i < 512; ++i) {
            const dvec3 out = dice.direction();
            const dvec3 aside = glm::normalize(glm::cross(out, dice.direction()));
            const double angle = dice.between(0, std::numbers::pi / 3);
            const dvec3 origin = (i % 2 == 0 ? 1 + part : 1 - part) * out;
            cases.add(std::pow(10, step / 2.0), origin,
                      origin - std::cos(angle) * out + std::sin(angle) * aside, {0, 0, 0}, 1);
        }
    }
    Sweep sweep({.name = "sphere_surface",
                 .kind = "sphere",
                 .title = "Rays that start near the surface",
                 .x_label = "radius / height over the surface",
                 .y_label = "error of the distance / radius",
                 .limit = 1e-5,
                 .stated = "to a millionth of the radius"},
                GetParam());
    measure(sweep, cases, to_radius);
    for (const char *series : {"haines", "haines, width=4"}) {
        sweep.expect_holds(series, 1e6);
    }
    sweep.expect_fails("haines", 1e8);  // a float is 6e-8 from the next: on which side is it?
}

}  // namespace
}  // namespace stagelight::stability
