// SPDX-License-Identifier: MIT
// How bright a surface is with a point light close by, far away, and at the end of its range. The
// truth is long double.
#include <cmath>

#include "device/device_types.h"
#include "kernels/on_device.h"
#include "reference/lights.h"
#include "reference/scenes.h"
#include "stability/sweep.h"

namespace stagelight::stability {
namespace {

using glm::dvec3, glm::vec2, glm::vec3, glm::vec4;
using reference::Dice;
using Real = long double;
using Exact = glm::vec<3, Real>;

using StabilityStage02Light = OnDevice;
INSTANTIATE_TEST_SUITE_P(On, StabilityStage02Light, each_device(), device_name);

const SceneNeeds one_light{{"HAS_LIGHTS", 1}, {"HAS_POINT_LIGHT", 1}, {"WIDTH", 4}};

// Lights of such an intensity that a white surface is as bright as the cosine, but for a range.
struct Cases {
    std::vector<double> x;
    std::vector<vec4> lights;  // position, and range
    std::vector<float> intensities;
    std::vector<vec4> points, normals;
    Dice dice;

    void add(double at, double distance, const dvec3 &point, double range = INFINITY) {
        const dvec3 normal = dice.direction();
        dvec3 towards = dice.direction();
        towards *= glm::dot(towards, normal) < 0 ? -1 : 1;
        x.push_back(at);
        points.emplace_back(vec3(point), 0);
        normals.emplace_back(vec3(normal), 0);
        lights.emplace_back(vec3(dvec3(points.back()) + distance * towards), range);
        intensities.push_back(float(distance > 0 ? distance * distance : 1));
    }

    // Floats all of them, so that the truth has the same.
    Light light(std::size_t i) const {
        return {.position = dvec3(lights[i]),
                .intensity = double(intensities[i]),
                .range = double(lights[i].w),
                .where = {}};
    }

    Real brightness(std::size_t i) const {
        const auto arriving = reference::light_at(light(i), Exact(points[i]));
        return std::max(Real(0), glm::dot(Exact(normals[i]), arriving.direction))
               * arriving.irradiance.x;
    }
};

std::vector<vec2> brightness(DeviceProgram program, const Cases &cases) {
    std::vector<device::Light> lights;
    for (std::size_t i = 0; i < cases.x.size(); ++i) {
        lights.push_back(to_device(cases.light(i)));
    }
    return program.run<vec2>("brightness", lights, cases.points, cases.normals);
}

void measure(Sweep &sweep, const DeviceProgram &program, const Cases &cases) {
    const auto results = brightness(program, cases);
    for (std::size_t i = 0; i < results.size(); ++i) {
        const Real truth = cases.brightness(i);
        sweep.add("one ray", cases.x[i], double(std::abs(results[i].x - truth)));
        sweep.add("side by side", cases.x[i], double(std::abs(results[i].y - truth)));
    }
}

Question question(const char *name, const char *title, const char *x_label, const char *stated) {
    return {.name = name,
            .kind = "light",
            .title = title,
            .x_label = x_label,
            .y_label = "error of the brightness, at most 1",
            .limit = 1.0 / 512,  // half a code
            .stated = stated};
}

TEST_P(StabilityStage02Light, NearFarAndAtItsRange) {
    Cases near, far, range;
    for (int power = 0; power <= 44; ++power) {
        const double x = std::pow(10, power / 2.0);
        for (int i = 0; i < 32; ++i) {
            // Among larger numbers too, as long as these can tell the two places apart.
            near.add(x, 1 / x, x <= 1e6 && i % 2 == 1 ? near.dice.direction() : dvec3(0));
            if (x < 1e19) {
                far.add(x, x, far.dice.direction());
            }
            if (x <= 1e7) {
                range.add(x, 1, dvec3(0), 1 / (1 - 0.999 / x));
            }
        }
    }
    const DeviceProgram program = build("brightness.cl", one_light);
    Sweep closer(question("light_near", "A light close to a surface", "1 / distance", "to 1e-18"),
                 GetParam());
    measure(closer, program, near);
    Sweep farther(question("light_far", "A light far from a surface", "distance", "to 1e18"),
                  GetParam());
    measure(farther, program, far);
    Sweep falloff(question("light_range", "A light's range ends", "1 / (1 - distance / range)",
                           "all of the range"),
                  GetParam());
    measure(falloff, program, range);
    for (const char *method : {"one ray", "side by side"}) {
        closer.expect_holds(method, 1e18);
        closer.expect_fails(method, 1e22);  // where float has no square of the distance
        farther.expect_holds(method, 1e18);
        falloff.expect_holds(method, 1e7);
    }
}

// Where the light is there is no direction to it: no light arrives, rather than NaN.
TEST_P(StabilityStage02Light, OnTheSurfaceItselfIsDark) {
    Cases cases;
    for (int i = 0; i < 64; ++i) {
        cases.add(1, 0, cases.dice.in_cube(9));
    }
    for (const vec2 &is : brightness(build("brightness.cl", one_light), cases)) {
        EXPECT_EQ(is, vec2(0));
    }
}

}  // namespace
}  // namespace stagelight::stability
