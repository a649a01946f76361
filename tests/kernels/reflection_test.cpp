// SPDX-License-Identifier: MIT
#include <cmath>

#include "device/opencl.h"
#include "kernels/on_device.h"
#include "kernels/worst.h"
#include "reference/optics.h"
#include "reference/scenes.h"

namespace stagelight {
namespace {

using glm::dvec3, glm::vec3, glm::vec4;
using reference::Dice;

using KernelsStage03Reflection = OnDevice;
INSTANTIATE_TEST_SUITE_P(On, KernelsStage03Reflection, each_device(), device_name);

constexpr int max_depth = 4;
const SceneNeeds with_stack{{"MAX_DEPTH", max_depth}, {"STACK_SIZE", 3}};

struct RayOut {
    vec4 origin, direction;
};

struct Cases {
    std::vector<vec4> directions, normals, geometric_normals;

    // The directions are turned to meet the facet from its front.
    Cases() {
        Dice dice;
        for (int i = 0; i < 8192; ++i) {
            const dvec3 geometric = dice.direction();
            dvec3 direction = dice.direction();
            if (i % 4 == 1) {  // all but along the facet
                const double lift = std::pow(10, dice.between(-9, -1));
                direction = glm::normalize(glm::cross(geometric, direction)) - lift * geometric;
            }
            direction = glm::normalize(direction);
            const double facing = glm::dot(direction, geometric) < 0 ? 1 : -1;
            const double lean = i % 2 == 1 ? 0 : dice.between(0, 0.95);
            add(direction, glm::normalize(facing * geometric + lean * dice.direction()),
                facing * geometric);
        }
        add({0, 0, -1}, {0, 0, 1}, {0, 0, 1});
        add({1, 0, 0}, {0, 0, 1}, {0, 0, 1});
        add({0.6, 0, -0.8}, {0, 1, 0}, {0, 0, 1});
    }
    void add(const dvec3 &direction, const dvec3 &normal, const dvec3 &geometric) {
        directions.emplace_back(vec3(direction), 0);
        normals.emplace_back(vec3(normal), 0);
        geometric_normals.emplace_back(vec3(geometric), 0);
    }
};

// Unit vectors rounded to float are off by up to an ulp of 1 in all, and reflecting doubles that,
// folding once more.
TEST_P(KernelsStage03Reflection, RaysMatchDouble) {
    const Cases cases;
    const auto rays =
        build("reflection.cl", with_stack)
            .run<RayOut>("reflected", cases.directions, cases.normals, cases.geometric_normals);
    Worst direction("direction"), length("length"), angle("angle"), origin("origin");
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const dvec3 d = glm::normalize(dvec3(cases.directions[i]));
        const dvec3 normal = glm::normalize(dvec3(cases.normals[i]));
        const dvec3 geometric = glm::normalize(dvec3(cases.geometric_normals[i]));
        const dvec3 is(rays[i].direction);
        direction.compare(i, is, reference::reflect(d, normal, geometric), 8 * ulp);
        length.compare(i, glm::length(is), 1, 2 * ulp);
        if (glm::dot(glm::reflect(d, normal), geometric) > 4 * ulp) {
            angle.compare(i, glm::dot(is, normal), -glm::dot(d, normal), 4 * ulp);
        }
        // Even a ray all but along the surface starts on the side that it was reflected to.
        origin.compare(i, dvec3(rays[i].origin), geometric, 2 * ulp);
    }
    direction.expect(8192);
    length.expect(8192);
    angle.expect(6000);
    origin.expect(8192);
}

// The last ray in is the first out; what is deeper than the limit is counted, not kept.
TEST_P(KernelsStage03Reflection, TheStackKeepsWhatMayBeTraced) {
    const std::vector<cl_int> depths{0, 2, 3, 4, 5};
    const auto results = build("reflection.cl", with_stack).run<cl_int4>("stack", depths);
    const std::vector<std::array<cl_int, 3>> expected{
        {321, 3, 0}, {321, 3, 0}, {21, 2, 1}, {1, 1, 2}, {0, 0, 3}};
    for (std::size_t i = 0; i < depths.size(); ++i) {
        EXPECT_EQ(results[i].s[0], expected[i][0]) << "order, from depth " << depths[i];
        EXPECT_EQ(results[i].s[1], expected[i][1]) << "traced, from depth " << depths[i];
        EXPECT_EQ(results[i].s[2], expected[i][2]) << "dropped, from depth " << depths[i];
        EXPECT_EQ(results[i].s[3], 0) << "depth of the primary ray";
    }
}

TEST_P(KernelsStage03Reflection, AMirrorSpawnsOneDeeperRay) {
    const auto results =
        build("reflection.cl", with_stack)
            .run<std::array<vec4, 2>>("spawned", std::vector<cl_int>{0, max_depth - 1, max_depth});
    for (const int i : {0, 1}) {
        const auto [direction_and_depth, weight_and_count] = results[std::size_t(i)];
        EXPECT_FLOAT_EQ(direction_and_depth.x, 0.6F);
        EXPECT_FLOAT_EQ(direction_and_depth.z, 0.8F);
        EXPECT_EQ(direction_and_depth.w, i == 0 ? 1 : max_depth) << "depth";
        EXPECT_EQ(weight_and_count, vec4(0.25F, 0.5F, 0.75F, 1)) << "weight, one reflection";
    }
    EXPECT_EQ(results[2][0].x, 10) << "one dropped beyond the depth limit, none reflected";
}

using KernelsStage11ImportanceCutoff = OnDevice;
INSTANTIATE_TEST_SUITE_P(On, KernelsStage11ImportanceCutoff, each_device(), device_name);

// Below 1/1024 in each channel a ray is not traced, however deep it is, and its largest channel is
// added up in units of 2^-24, rounded up. Stages that know no such limit trace what weighs nothing.
TEST_P(KernelsStage11ImportanceCutoff, RaysAreNotTracedButWeighed) {
    const float limit = 1.0F / 1024, below = std::nextafter(limit, 0.0F);
    const std::vector<vec4> weights{{1, 1, 1, 0},
                                    {0, limit, 0, 1},
                                    {below, below / 2, 0, 1},
                                    {0, 0, 1e-9F, max_depth + 1},
                                    {0, 0, limit, max_depth + 1},
                                    {0, 0, 0, 0}};
    using Counts = std::vector<glm::uvec4>;
    SceneNeeds needs = with_stack;
    EXPECT_EQ(
        build("reflection.cl", needs).run<glm::uvec4>("cut_off", weights),
        (Counts{
            {1, 0, 0, 0}, {1, 0, 0, 0}, {1, 0, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {1, 0, 0, 0}}));
    needs.emplace_back("CUTOFF_ONE_IN", 1024);
    EXPECT_EQ(build("reflection.cl", needs).run<glm::uvec4>("cut_off", weights),
              (Counts{{1, 0, 0, 0},
                      {1, 0, 0, 0},
                      {0, 0, 1, 16384},
                      {0, 0, 1, 1},
                      {0, 1, 0, 0},
                      {0, 0, 1, 0}}));
}

}  // namespace
}  // namespace stagelight
