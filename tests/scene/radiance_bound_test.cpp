// SPDX-License-Identifier: MIT
#include "scene/radiance_bound.h"

#include <gtest/gtest.h>

namespace stagelight {
namespace {

Scene with(MaterialType type) {
    Scene scene;
    scene.background = {0.2, 0.5, 0.3};
    scene.materials.push_back({.type = type, .where = {}});
    return scene;
}

void add_lamp(Scene &scene, glm::dvec3 position, double intensity) {
    scene.lights.push_back(
        {.position = position, .color = {1, 0.5, 0}, .intensity = intensity, .where = {}});
}

TEST(RadianceBound, IsTheBackgroundWhereNothingIsLit) {
    EXPECT_EQ(radiance_bound(Scene{}), 0);
    Scene mirror = with(MaterialType::mirror);
    mirror.spheres.push_back({.where = {}});
    add_lamp(mirror, {0, 3, 0}, 100);
    EXPECT_EQ(radiance_bound(mirror), 0.5);
}

// 18 over the square of the least distance: 3 above a plane, 2 above the ball on it or within it 1.
TEST(RadianceBound, IsALampOnTheSurfaceNearestToIt) {
    Scene scene = with(MaterialType::diffuse);
    scene.planes.push_back({.where = {}});
    add_lamp(scene, {0, 3, 0}, 18);
    EXPECT_DOUBLE_EQ(radiance_bound(scene), 2);
    scene.spheres.push_back({.where = {}});
    EXPECT_DOUBLE_EQ(radiance_bound(scene), 4.5);
    scene.spheres[0].radius = 4;
    EXPECT_DOUBLE_EQ(radiance_bound(scene), 18);
    scene.lights[0].range = 1;
    EXPECT_EQ(radiance_bound(scene), 0.5);
}

TEST(RadianceBound, AddsLightsOfAllKinds) {
    Scene scene = with(MaterialType::glossy);
    scene.planes.push_back({.where = {}});
    add_lamp(scene, {0, 3, 0}, 18);
    add_lamp(scene, {5, -1, 0}, 4);
    scene.lights.push_back({.type = LightType::directional, .intensity = 0.5, .where = {}});
    EXPECT_DOUBLE_EQ(radiance_bound(scene), 6.5);
}

// Beside a triangle that lies flat its box counts, above a steep one its plane.
TEST(RadianceBound, IsNotLessThanOnATriangle) {
    Scene scene = with(MaterialType::diffuse);
    scene.vertices = {{{0, 0, 0}, {}, {}}, {{1, 0, 0}, {}, {}}, {{0, 0, 1}, {}, {}}};
    scene.triangles.push_back({.vertices = {0, 1, 2}});
    add_lamp(scene, {3, 0, 0}, 8);
    EXPECT_DOUBLE_EQ(radiance_bound(scene), 2);
    scene.lights[0].position = {0.1, -2, 0.1};
    EXPECT_DOUBLE_EQ(radiance_bound(scene), 2);
    scene.vertices[1].position = {1, 1, 0};
    scene.vertices[2].position = {0, 0, 9};
    scene.lights[0].position = {0.25, 0.75, 1};  // half of the root of two from the plane x = y
    EXPECT_DOUBLE_EQ(radiance_bound(scene), 64);
}

}  // namespace
}  // namespace stagelight
