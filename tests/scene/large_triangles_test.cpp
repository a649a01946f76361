// SPDX-License-Identifier: MIT
// Grounds of any size under small things.
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "scene/large_triangles.h"

namespace stagelight {
namespace {

using glm::dvec3;

Scene coin_on_ground(double reach) {
    Scene scene;
    scene.camera.position = {0, 1.5, 2};
    const auto corner = [&](double x, double z) {
        return Vertex{
            reach * dvec3(x, 0, z), {0, 1, 0}, {(x + 1) / 2, (z + 1) / 2}, {(x + 1) / 2, 1, 0}};
    };
    scene.vertices = {corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)};
    scene.triangles = {{.vertices = {3, 2, 1}, .material = 2},
                       {.vertices = {3, 1, 0}, .material = 2}};
    for (const auto &[x, z] : {std::pair(-0.5, -0.5), {0.5, -0.5}, {0.0, 0.5}}) {
        scene.vertices.push_back({{x, 0.05, z}, {0, 1, 0}, {}});
    }
    scene.triangles.push_back({.vertices = {6, 5, 4}});
    return scene;
}

dvec3 twice_area(const Scene &scene, const Triangle &triangle) {
    const auto at = [&](std::size_t i) { return scene.vertices[triangle.vertices[i]].position; };
    return glm::cross(at(1) - at(0), at(2) - at(0));
}

TEST(LargeTriangles, AreCutWhereSomethingSmallIsNear) {
    for (const double reach : {1e3, 1e4, 1e6, 1e9}) {
        SCOPED_TRACE(reach);
        Scene scene = coin_on_ground(reach);
        cut_large_triangles(scene);
        EXPECT_GT(scene.triangles.size(), 20u);
        EXPECT_LT(scene.triangles.size(), 500u);
        dvec3 area(0);
        double at_coin = 0;
        for (const Triangle &triangle : scene.triangles) {
            if (triangle.material != 2) {
                continue;
            }
            const dvec3 part = twice_area(scene, triangle);
            EXPECT_GT(part.y, 0);  // none is turned round
            area += part;
            double nearest = reach, longest = 0;
            for (std::size_t i = 0; i < 3; ++i) {
                const Vertex &here = scene.vertices[triangle.vertices[i]],
                             &next = scene.vertices[triangle.vertices[(i + 1) % 3]];
                EXPECT_EQ(here.texture_coordinates.x, (here.position.x / reach + 1) / 2);
                EXPECT_EQ(here.color, dvec3(here.texture_coordinates.x, 1, 0));
                EXPECT_EQ(here.normal, dvec3(0, 1, 0));
                nearest = std::min(nearest, glm::length(here.position));
                longest = std::max(longest, glm::distance(here.position, next.position));
            }
            at_coin = nearest < 1 ? std::max(at_coin, longest) : at_coin;
        }
        EXPECT_NEAR(area.y / (8 * reach * reach), 1, 1e-14);
        EXPECT_LT(at_coin, 24 * 1.5);
    }
}

// Each edge has a triangle on either side, but for the ground's own rim: no ray slips through.
TEST(LargeTriangles, StayClosed) {
    Scene scene = coin_on_ground(1e5);
    cut_large_triangles(scene);
    std::map<std::pair<std::pair<double, double>, std::pair<double, double>>, int> sides;
    for (const Triangle &triangle : scene.triangles) {
        for (std::size_t i = 0; triangle.material == 2 && i < 3; ++i) {
            const dvec3 a = scene.vertices[triangle.vertices[i]].position,
                        b = scene.vertices[triangle.vertices[(i + 1) % 3]].position;
            ++sides[std::minmax(std::pair(a.x, a.z), std::pair(b.x, b.z))];
        }
    }
    for (const auto &[edge, count] : sides) {
        const auto &[a, b] = edge;
        const bool rim = (a.first == b.first && std::abs(a.first) == 1e5)
                         || (a.second == b.second && std::abs(a.second) == 1e5);
        EXPECT_EQ(count, rim ? 1 : 2);
    }
}

TEST(LargeTriangles, StayWhereNothingIsSmallOrNear) {
    Scene small = coin_on_ground(10), far = coin_on_ground(1e5);
    for (Vertex &vertex : far.vertices) {
        vertex.position.y += vertex.position.y > 0 ? 1e5 : 0;  // the coin, up in the sky
    }
    far.camera.position.y = 1e5;
    for (Scene *scene : {&small, &far}) {
        const auto vertices = scene->vertices.size(), triangles = scene->triangles.size();
        cut_large_triangles(*scene);
        EXPECT_EQ(scene->vertices.size(), vertices);
        EXPECT_EQ(scene->triangles.size(), triangles);
    }
}

}  // namespace
}  // namespace stagelight
