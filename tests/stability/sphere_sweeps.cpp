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

using StabilityStage09Sphere = OnDevice;
INSTANTIATE_TEST_SUITE_P(On, StabilityStage09Sphere, each_device(), device_name);

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

// Every method's relative error of the distance; 1 where one hits and the other misses.
void measure(Sweep &sweep, DeviceProgram program, const Cases &cases) {
    for (const char *method : methods) {
        const auto distances =
            program.run<float>(method, cases.origins, cases.directions, cases.spheres);
        for (std::size_t i = 0; i < distances.size(); ++i) {
            const long double truth =
                true_distance(cases.origins[i], cases.directions[i], cases.spheres[i]);
            const bool agree = std::isinf(distances[i]) == std::isinf(truth);
            const double error =
                std::isinf(truth) ? 0 : double(std::abs(distances[i] - truth) / truth);
            sweep.add(method, cases.x[i], agree ? error : 1);
        }
    }
}

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
                 .stated = "to 10 million radii away"},
                GetParam());
    measure(sweep, build("wide_sphere.cl", {{"WIDTH", 1}}), cases);
    sweep.expect_holds("haines", 1e7);
    sweep.expect_fails("textbook", 1e3);
}

}  // namespace
}  // namespace stagelight::stability
