// SPDX-License-Identifier: MIT
// Diffuse shading and hard shadows.
#include "scenes.h"

namespace stagelight::reference {
namespace {

const dvec3 paint(0.9, 0.5, 0.2);
const dvec3 lamp(1, 0.8, 0.4);

Scene floor_scene() {
    Scene scene;
    scene.background = {7, 7, 7};  // to be seen nowhere
    add_plane(scene, {0, 1, 0}, {0, 0, 0}, diffuse(paint));
    return scene;
}

// What a ray straight down from a tenth above the floor sees at (x, 0, 0).
dvec3 floor_at(const Scene &scene, double x) {
    return seen(scene, ray({x, 0.1, 0}, {0, -1, 0}));
}

// Below a point light at the height 2, N · L = 1 and r = 2: c · color · I / 4. Aside by 1.5, r is
// 2.5 and N · L = 2 / 2.5.
TEST(ReferenceStage02Diffuse, PointLightFallsWithTheSquareAndTheCosine) {
    Scene scene = floor_scene();
    add_point_light(scene, {0, 2, 0}, lamp, 10);
    expect_near(floor_at(scene, 0), paint * lamp * 2.5, 1e-14);
    expect_near(floor_at(scene, 1.5), paint * lamp * (10 / 6.25 * 0.8), 1e-14);
}

TEST(ReferenceStage02Diffuse, LightsAddUp) {
    Scene scene = floor_scene();
    add_point_light(scene, {0, 2, 0}, lamp, 10);
    add_point_light(scene, {1.5, 2, 0}, {0, 0, 1}, 1);
    expect_near(floor_at(scene, 0), paint * (lamp * 2.5 + dvec3(0, 0, 1) / 6.25 * 0.8), 1e-14);
}

// With r / range = 1/2 the window is (1 - 1/16)²; at the range and beyond it is 0.
TEST(ReferenceStage02Diffuse, ARangeEndsAPointLightSmoothly) {
    Scene scene = floor_scene();
    add_point_light(scene, {0, 2, 0}, lamp, 10);
    scene.lights[0].range = 4;
    expect_near(floor_at(scene, 0), paint * lamp * 2.5 * (225.0 / 256), 1e-14);
    scene.lights[0].range = 2;
    expect_near(floor_at(scene, 0), {0, 0, 0}, 0);
    scene.lights[0].range = 1;
    expect_near(floor_at(scene, 0), {0, 0, 0}, 0);
}

// A light that comes down at 60° to the floor's normal: N · L = 1/2, at any distance.
TEST(ReferenceStage02Diffuse, DirectionalLightKnowsOnlyTheCosine) {
    Scene scene = floor_scene();
    add_directional_light(scene, {std::sqrt(0.75), -0.5, 0}, lamp, 3);
    expect_near(floor_at(scene, 0), paint * lamp * 1.5, 1e-14);
    expect_near(floor_at(scene, 1e4), paint * lamp * 1.5, 1e-14);
}

TEST(ReferenceStage02Diffuse, LightFromBehindTheFloorDoesNotCount) {
    Scene scene = floor_scene();
    add_point_light(scene, {0, -2, 0}, lamp, 10);
    add_directional_light(scene, {0, 1, 0}, lamp, 10);
    expect_near(floor_at(scene, 0), {0, 0, 0}, 0);
    // Seen from below the normal is turned: there it is the light.
    expect_near(seen(scene, ray({0, -1, 0}, {0, 1, 0})), paint * lamp * 12.5, 1e-13);
}

// From a light at the height H the sphere of radius r at the height h fills a cone of half angle
// a, sin a = r / (H - h). The cone meets the floor in a circle of radius
// H tan a = H r / sqrt((H - h)² - r²).
TEST(ReferenceStage02Shadow, OfASphereEndsWhereTheTangentMeetsTheFloor) {
    const double H = 5, h = 2, r = 0.5;
    const double edge = H * r / std::sqrt((H - h) * (H - h) - r * r);
    Scene scene = floor_scene();
    add_sphere(scene, {0, h, 0}, r, {});
    add_point_light(scene, {0, H, 0}, lamp, 10);
    expect_near(floor_at(scene, edge * (1 - 1e-11)), {0, 0, 0}, 0);
    const double distance_squared = H * H + edge * edge;
    const double cosine = H / std::sqrt(distance_squared);
    expect_near(floor_at(scene, edge * (1 + 1e-11)),
                paint * lamp * (10 / distance_squared * cosine), 1e-10);
}

// Parallel light that falls straight down: the shadow is as wide as the sphere.
TEST(ReferenceStage02Shadow, UnderParallelLightIsAsWideAsTheSphere) {
    Scene scene = floor_scene();
    add_sphere(scene, {0, 1e4, 0}, 0.5, {});
    add_directional_light(scene, {0, -1, 0}, lamp, 1);
    expect_near(floor_at(scene, 0.5 - 1e-9), {0, 0, 0}, 0);
    expect_near(floor_at(scene, 0.5 + 1e-9), paint * lamp, 1e-14);
}

// A shadow *line* ends at the light; a shadow *ray* goes on.
TEST(ReferenceStage02Shadow, WhatStandsBeyondAPointLightCastsNone) {
    for (const double height : {1.0, 3.0}) {
        Scene scene = floor_scene();
        add_sphere(scene, {0, height, 0}, 0.5, {});
        add_point_light(scene, {0, 2, 0}, lamp, 10);
        expect_near(floor_at(scene, 0), height < 2 ? dvec3(0) : paint * lamp * 2.5, 1e-14);
    }
}

// Planes, triangles and glass stand in the way like all else.
TEST(ReferenceStage02Shadow, EverythingCastsAFullOne) {
    Scene under_plane = floor_scene(), under_triangle = floor_scene(), under_glass = floor_scene();
    add_plane(under_plane, {0, 1, 0}, {0, 1, 0}, {});
    add_flat_triangle(under_triangle, {-3, 1, -3}, {3, 1, -3}, {0, 1, 3});
    add_sphere(under_glass, {0, 1, 0}, 0.5, glass({1, 1, 1}, 1.5, {}));
    for (Scene *scene : {&under_plane, &under_triangle, &under_glass}) {
        add_point_light(*scene, {0, 2, 0}, lamp, 10);
        add_directional_light(*scene, {0, -1, 0}, lamp, 1);
        expect_near(floor_at(*scene, 0), {0, 0, 0}, 0);
    }
}

// A surface does not shade itself, at any scale and anywhere: a sphere lit from the eye has
// N · L = cos of the angle at each point it shows.
TEST(ReferenceStage02Shadow, NothingShadesItself) {
    Dice dice;
    for (const double scale : {1e-6, 1.0, 1e6})
        for (int i = 0; i < 500; ++i) {
            Scene scene;
            const dvec3 center = scale * dice.in_cube(100);
            add_sphere(scene, center, scale, diffuse({1, 1, 1}));
            const dvec3 target = center + scale * dice.in_cube(0.57);
            const dvec3 direction = dice.direction();
            const auto along = ray(target - 3 * scale * direction, direction);
            add_directional_light(scene, along.direction, {1, 1, 1}, 1);
            const RayTree tree = met(scene, along);
            ASSERT_EQ(tree.surface.kind, Surface::Kind::sphere) << "scale " << scale;
            EXPECT_EQ(tree.shadows.at(0), Shadow::lit) << "scale " << scale;
        }
}

}  // namespace
}  // namespace stagelight::reference
