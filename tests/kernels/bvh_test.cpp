// SPDX-License-Identifier: MIT
#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <set>

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include "kernels/on_device.h"
#include "scene_types.h"

namespace stagelight {
namespace {

using glm::vec3;
using glm::vec4;
constexpr float infinity = std::numeric_limits<float>::infinity();

class KernelsStage10Slabs : public OnDevice {
protected:
    // Rusticl's compiler takes half a minute for what is 16 wide.
    static int widest() { return on_rusticl() ? 4 : 16; }
};
INSTANTIATE_TEST_SUITE_P(On, KernelsStage10Slabs, each_device(), device_name);

SceneNeeds with_tree(int width) {
    return {{"HAS_TRIANGLES", 1}, {"HAS_TREE", 1}, {"WIDTH", width}, {"BVH_STACK_SIZE", 1}};
}

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
    {"a point", {0, 0.5F, 4}, {0, 0, -1}, 4, {0, 0.5F, 0}, {0, 0.5F, 0}},
    {"one that is missing", {0, 0, 4}, {1, 1, -1}, infinity, vec3(infinity), vec3(-infinity)},
    {"far away", {1e15F, 0, 0}, {-1, 0, 0}, 1e15F},
    {"large", {0, 0, 4e12F}, {0, 0, -1}, 3e12F, vec3(-1e12F), vec3(1e12F)},
};

using device::BvhNode;

// The box, padded as common/device/bvh.cpp does.
void put_box(BvhNode &node, std::size_t child, const vec3 &low, const vec3 &high) {
    float padding = 0;
    for (int axis = 0; axis < 3; ++axis) {
        if (std::isfinite(low[axis])) {
            padding = std::max({padding, std::abs(low[axis]), std::abs(high[axis])});
        }
    }
    padding *= SLAB_PADDING;
    for (int axis = 0; axis < 3; ++axis) {
        node.planes[axis].s[child] = low[axis] - padding;
        node.planes[axis + 3].s[child] = high[axis] + padding;
    }
}

TEST_P(KernelsStage10Slabs, AreEnteredWhereTheClosedFormSays) {
    std::vector<vec4> origins, directions;
    std::vector<BvhNode> nodes;
    std::vector<float> limits;
    for (const Case &it : cases) {
        origins.emplace_back(it.origin, 0);
        directions.emplace_back(it.direction, 0);
        limits.push_back(it.limit);
        put_box(nodes.emplace_back(), 0, it.low, it.high);
        const vec3 behind = it.origin - (2 + glm::length(it.origin)) * it.direction;
        for (std::size_t child = 1; child < 4; ++child) {
            put_box(nodes.back(), child, behind - vec3(1e-3F), behind + vec3(1e-3F));
        }
    }
    for (const int width : std::set{1, 4, widest()}) {
        SCOPED_TRACE(width);
        const std::vector<vec4> results =
            build(width == 1 ? "tree.cl" : "packet_boxes.cl", with_tree(width))
                .run<vec4>("enter", origins, directions, nodes, limits);
        for (std::size_t i = 0; i < cases.size(); ++i) {
            const bool enters = cases[i].expected < infinity;
            if (cases[i].low.x <= cases[i].high.x) {  // a ray is not tried against what is missing
                EXPECT_EQ(results[i].x, enters) << cases[i].what;
            }
            EXPECT_EQ(results[i].z, enters) << cases[i].what << ": and no other child's box";
            EXPECT_EQ(results[i].w, enters) << cases[i].what << ": the packet";
            if (enters) {
                EXPECT_NEAR(results[i].y, cases[i].expected, 1e-6F * cases[i].expected + 1e-6F)
                    << cases[i].what;
            }
        }
    }
}

// No box that any of its rays enters is left out by the beam, or by the ray's packet, and where
// rays run side by side it enters few that none of them does.
TEST_P(KernelsStage10Slabs, ABeamEntersWhatAnyOfItsRaysEnters) {
    constexpr std::size_t count = 4096;
    const int width = widest();
    const auto together = 4 * static_cast<std::size_t>(width);
    std::mt19937 random(9);
    std::uniform_real_distribution<float> within(-1, 1);
    const auto point = [&] { return vec3(within(random), within(random), within(random)); };
    for (const float spread : {0.0F, 0.01F, 2.0F}) {
        std::vector<vec4> origins, directions;
        std::vector<BvhNode> nodes(count);
        vec3 origin, direction;
        for (std::size_t i = 0; i < count; ++i) {
            if (i % together == 0) {
                origin = 3.0F * point();
                direction = 0.5F * point() - origin;
            }
            origins.emplace_back(origin + 0.1F * spread * point(), 0);
            directions.emplace_back(direction + spread * point(), 0);
            for (std::size_t child = 0; child < 4; ++child) {
                const vec3 low = point();
                put_box(nodes[i], child, low, low + 0.5F * (point() + vec3(1)));
            }
        }
        const std::vector<glm::ivec4> results =
            build("packet_boxes.cl", with_tree(width))
                .run<glm::ivec4>("enter_together", origins, directions, nodes);
        int entered = 0;
        int more = 0;
        for (const glm::ivec4 &result : results) {
            EXPECT_EQ(result.y & ~result.x, 0) << "left out at a spread of " << spread;
            EXPECT_EQ(result.z, 0) << "a packet left out at a spread of " << spread;
            entered += std::popcount(unsigned(result.y));
            more += std::popcount(unsigned(result.x & ~result.y));
        }
        EXPECT_GT(entered, 300);
        if (spread < 1) {
            EXPECT_LT(more, entered / 5) << "at a spread of " << spread;
        }
    }
}

}  // namespace
}  // namespace stagelight
