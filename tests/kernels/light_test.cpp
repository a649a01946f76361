// SPDX-License-Identifier: MIT
#include "reference/lights.h"

#include <cmath>

#include "device/device_types.h"
#include "kernels/on_device.h"
#include "kernels/worst.h"
#include "reference/scenes.h"

namespace stagelight {
namespace {

using glm::dvec3, glm::vec3, glm::vec4;
using reference::Dice;

using KernelsStage02Light = OnDevice;
INSTANTIATE_TEST_SUITE_P(On, KernelsStage02Light, each_device(), device_name);

const SceneNeeds both_kinds{
    {"HAS_LIGHTS", 1}, {"HAS_POINT_LIGHT", 1}, {"HAS_DIRECTIONAL_LIGHT", 1}};

struct Illumination {
    vec4 direction, irradiance;
};

struct Cases {
    std::vector<Light> lights;
    std::vector<vec4> points;

    // The light's numbers are made floats, so that the reference gets the same.
    void add(Light light, const dvec3 &point) {
        light.position = dvec3(vec3(light.position));
        light.direction = dvec3(vec3(light.direction));
        light.range = double(float(light.range));
        lights.push_back(light);
        points.emplace_back(vec3(point), 0);
    }
};

// From a thousandth to a million away, in reach of some lights and out of that of others.
Cases random_lights() {
    Dice dice;
    Cases cases;
    for (int i = 0; i < 4096; ++i) {
        const double distance = std::pow(10, dice.between(-3, 6));
        Light light;
        light.type = i % 4 == 0 ? LightType::directional : LightType::point;
        light.position = distance * dice.in_cube(1);
        light.direction = dice.direction();
        light.color = {dice.between(0, 1), dice.between(0, 1), dice.between(0, 1)};
        light.intensity = std::pow(10, dice.between(-2, 4));
        if (i % 2 == 1) {
            light.range = distance * dice.between(0.3, 3);
        }
        cases.add(light, light.position + distance * dice.direction());
    }
    return cases;
}

TEST_P(KernelsStage02Light, LightArrivesAsInDouble) {
    const Cases cases = random_lights();
    std::vector<device::Light> lights;
    for (const Light &light : cases.lights) {
        lights.push_back(to_device(light));
    }
    const auto results =
        build("light.cl", both_kinds).run<Illumination>("lights_at", lights, cases.points);
    Worst direction("direction"), irradiance("irradiance");
    for (std::size_t i = 0; i < results.size(); ++i) {
        Light light = cases.lights[i];
        const auto truth = reference::light_at(light, dvec3(cases.points[i]));
        light.range = INFINITY;
        // The window is a difference from 1, so its rounding is that of light without it.
        const double size =
            glm::length(reference::light_at(light, dvec3(cases.points[i])).irradiance);
        direction.compare(i, dvec3(results[i].direction), truth.direction, 4 * ulp);
        irradiance.compare(i, dvec3(results[i].irradiance), truth.irradiance, 8 * ulp * size);
    }
    direction.expect(4096);
    irradiance.expect(4096);
}

// docs/shading.md: E = color · intensity / r², times (1 - (r / range)⁴)², at r = 2.
TEST_P(KernelsStage02Light, TheRangeEndsALight) {
    struct Case {
        double range, share;
        const char *what;
    };
    const std::vector<Case> list{
        {INFINITY, 1, "no range"},
        {1e18, 1, "a range beyond all"},
        {4, 225.0 / 256, "half the range"},
        {2, 0, "at the range"},
        {1.9999, 0, "just beyond"},
        {1, 0, "beyond"},
        {1e-15, 0, "so far beyond that (r / range)⁴ overflows"},
    };
    std::vector<device::Light> lights;
    for (const Case &it : list) {
        lights.push_back(to_device(
            Light{.color = {1, 0.5, 0.25}, .intensity = 8, .range = it.range, .where = {}}));
    }
    const auto results =
        build("light.cl", both_kinds)
            .run<Illumination>("lights_at", lights, std::vector(list.size(), vec4(0, 0, 2, 0)));
    for (std::size_t i = 0; i < list.size(); ++i) {
        EXPECT_FLOAT_EQ(results[i].irradiance.x, float(2 * list[i].share)) << list[i].what;
        EXPECT_FLOAT_EQ(results[i].irradiance.z, float(0.5 * list[i].share)) << list[i].what;
    }
}

TEST_P(KernelsStage02Light, RaysOfAllWorkItemsAreCounted) {
    std::vector<device::RayCounts> counts;
    device::RayCounts sum{};
    for (device::uint i = 0; i < 4096; ++i) {
        counts.push_back({i % 2, i % 3, i % 5, i % 7 == 0 ? 1U : 0U, 0, 0});
        sum.shadow += counts.back().shadow;
        sum.reflection += counts.back().reflection;
        sum.refraction += counts.back().refraction;
        sum.dropped += counts.back().dropped;
    }
    const auto row = build("light.cl", both_kinds).run<device::RayCounts>("count_rays", counts)[0];
    EXPECT_EQ(row.shadow, sum.shadow);
    EXPECT_EQ(row.reflection, sum.reflection);
    EXPECT_EQ(row.refraction, sum.refraction);
    EXPECT_EQ(row.dropped, sum.dropped);
}

using KernelsStage11Counts = OnDevice;
INSTANTIATE_TEST_SUITE_P(On, KernelsStage11Counts, each_device(), device_name);

// The rays are summed, of the weights the largest is kept: a row has many pixels.
TEST_P(KernelsStage11Counts, KeepTheLargestWeightCutOff) {
    std::vector<device::RayCounts> counts;
    for (device::uint i = 0; i < 4096; ++i) {
        counts.push_back({0, 0, 0, 0, i % 3, i % 3 == 0 ? 0U : (i * 7919) % 4096});
    }
    SceneNeeds needs = both_kinds;
    needs.emplace_back("CUTOFF_ONE_IN", 1024);
    const auto row = build("light.cl", needs).run<device::RayCounts>("count_rays", counts)[0];
    EXPECT_EQ(row.cut_off, 4095U);
    EXPECT_EQ(row.cut_off_weight, 4095U);
}

}  // namespace
}  // namespace stagelight
