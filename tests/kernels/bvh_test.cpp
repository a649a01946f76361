// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include <glm/vec4.hpp>

#include "kernels/on_device.h"
#include "scene_types.h"

namespace stagelight {
namespace {

using glm::vec3;
using glm::vec4;
constexpr float infinity = std::numeric_limits<float>::infinity();

using KernelsStage09Slabs = OnDevice;
INSTANTIATE_TEST_SUITE_P(On, KernelsStage09Slabs, each_device(), device_name);

const SceneNeeds with_tree{{"TRIANGLE_COUNT", 1}, {"BVH_DEPTH", 1}};

struct Case {
    const char *what;
    vec3 origin, direction;
    float expected;  // infinity for a miss
    vec3 low{-1, -1, -1}, high{1, 1, 1};
    float limit = infinity;
};

const std::vector<Case> cases{
    {"from outside", {0, 0, 4}, {0, 0, -1}, 3},
    {"away from it", {0, 0, 4}, {0, 0, 1}, infinity},
    {"from inside", {0, 0, 0}, {0, 1, 0}, 0},
    {"askew", {4, 4, 0}, {-1, -1, 0}, 3},
    {"askew past an edge", {4, 1, 0}, {-1, 1, 0}, infinity},
    {"zeros, beside it", {2, 0, 4}, {0, 0, -1}, infinity},
    {"negative zeros", {0, 0, 4}, {-0.0F, -0.0F, -1}, 3},
    {"negative zeros, beside it", {2, 0, 4}, {-0.0F, -0.0F, -1}, infinity},
    {"along the low plane", {-1, 0, 4}, {0, 0, -1}, 3},
    {"along the high plane", {1, 0, 4}, {0, 0, -1}, 3},
    {"along the low plane, negative zero", {-1, 0, 4}, {-0.0F, 0, -1}, 3},
    {"along the high plane, negative zero", {1, 0, 4}, {-0.0F, 0, -1}, 3},
    {"along an edge", {1, 1, 4}, {0, 0, -1}, 3},
    {"on its face, inwards", {0, 0, 1}, {0, 0, -1}, 0},
    {"on its face, along it", {0, 0, 1}, {1, 0, 0}, 0},
    {"on its corner, along an edge", {1, 1, 1}, {0, 0, -1}, 0},
    {"just before the limit", {0, 0, 4}, {0, 0, -1}, 3, {-1, -1, -1}, {1, 1, 1}, 3.0001F},
    {"just beyond the limit", {0, 0, 4}, {0, 0, -1}, infinity, {-1, -1, -1}, {1, 1, 1}, 2.9999F},
    {"a flat box", {0.5F, 0.5F, 4}, {0, 0, -1}, 4, {0, 0, 0}, {1, 1, 0}},
    {"along a flat box", {4, 0.5F, 0}, {-1, 0, 0}, 3, {0, 0, 0}, {1, 1, 0}},
    {"a point", {0, 0, 4}, {0, 0, -1}, 4, {0, 0, 0}, {0, 0, 0}},
    {"a box that is nowhere", {0, 0, 4}, {0, 0, -1}, infinity, vec3(infinity), vec3(infinity)},
    {"one that is nowhere, upwards",
     {0, 0, 0},
     {1, 1, 1},
     infinity,
     vec3(infinity),
     vec3(infinity)},
    {"far away", {1e30F, 0, 0}, {-1, 0, 0}, 1e30F},
    {"large", {0, 0, 4e30F}, {0, 0, -1}, 3e30F, vec3(-1e30F), vec3(1e30F)},
};

TEST_P(KernelsStage09Slabs, AreEnteredWhereTheClosedFormSays) {
    std::vector<vec4> origins, directions;
    std::vector<device::BvhChild> boxes;
    std::vector<float> limits;
    for (const Case &it : cases) {
        origins.emplace_back(it.origin, 0);
        directions.emplace_back(it.direction, 0);
        boxes.push_back({{it.low.x, it.low.y, it.low.z}, 0, {it.high.x, it.high.y, it.high.z}, 0});
        limits.push_back(it.limit);
    }
    const std::vector<float> enters =
        build("bvh.cl", with_tree).run<float>("enter", origins, directions, boxes, limits);
    for (std::size_t i = 0; i < cases.size(); ++i) {
        if (cases[i].expected == infinity) {
            EXPECT_EQ(enters[i], infinity) << cases[i].what;
        } else {
            EXPECT_NEAR(enters[i], cases[i].expected, 1e-6F * cases[i].expected) << cases[i].what;
        }
    }
}

}  // namespace
}  // namespace stagelight
