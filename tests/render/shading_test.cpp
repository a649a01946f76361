// SPDX-License-Identifier: MIT
// Stage 02 against answers worked out by hand.
#include "render/on_each_device.h"

namespace stagelight::render {
namespace {

class Stage02Light : public OnEachDevice {};
class Stage02Shadow : public OnEachDevice {};
INSTANTIATE_TEST_SUITE_P(Devices, Stage02Light, each_device(), device_name);
INSTANTIATE_TEST_SUITE_P(Devices, Stage02Shadow, each_device(), device_name);

constexpr auto stage = "02_shading_shadows";
const dvec3 paint(0.9, 0.5, 0.2), white(1, 1, 1);

// A wall 2 ahead, whose middle pixel is its foot point: 9 columns, the half width of the view 1.
Scene wall() {
    Scene scene = one_pixel({0, 0, 0}, {0, 0, -1});
    scene.width = 9;
    scene.camera.fov = 90;
    add_plane(scene, {0, 0, 1}, {0, 0, -2}, diffuse(paint));
    return scene;
}

// A light at the eye, which sees the wall at the slant x: it is 2 sqrt(1 + x²) away, and the
// cosine is 1 / sqrt(1 + x²): colour * I / (4 (1 + x²)^(3/2)), head-on colour * I / 4.
TEST_P(Stage02Light, FallsOffWithTheSquareOfTheDistanceAndTheCosine) {
    Scene scene = wall();
    add_point_light(scene, {0, 0, 0}, {1, 0.5, 0.25}, 12);
    const Frame frame = draw(stage, scene);
    expect_color(frame.image, 4, 0, paint * dvec3(1, 0.5, 0.25) * 3.0);
    for (int column = 0; column < 9; ++column) {
        const double x = (column - 4) * 2.0 / 9;
        expect_color(frame.image, column, 0,
                     paint * dvec3(1, 0.5, 0.25) * 3.0 / std::pow(1 + x * x, 1.5));
    }
    EXPECT_EQ(frame.rays.shadow, 9u);
}

// Half-way to its range the window is (1 - 1/16)² = (15/16)²; at the range and beyond it is 0.
TEST_P(Stage02Light, EndsAtItsRange) {
    Scene scene = wall();
    scene.width = 1;
    add_point_light(scene, {0, 0, 0}, white, 12);
    for (const auto &[range, window] : {std::pair{4.0, 15.0 * 15 / 256}, {2.0, 0.0}, {1.5, 0.0}}) {
        scene.lights[0].range = range;
        expect_color(draw(stage, scene).image, 0, 0, paint * 3.0 * window);
    }
}

// Two directional lights, at 60 degrees and from behind the wall: the sum is the first's alone.
// Only the light that the wall faces is asked for its shadow.
TEST_P(Stage02Light, FromADirectionCountsItsCosine) {
    Scene scene = wall();
    add_directional_light(scene, {std::sqrt(0.75), 0, -0.5}, white, 0.8);
    add_directional_light(scene, {0, 0, 1}, white, 5);
    const Frame frame = draw(stage, scene);
    for (int column = 0; column < 9; ++column) {
        expect_color(frame.image, column, 0, paint * 0.4);
    }
    EXPECT_EQ(frame.rays.shadow, 9u);
    EXPECT_EQ(frame.rays.primary, 9u);
    EXPECT_EQ(frame.rays.reflection + frame.rays.refraction + frame.rays.dropped, 0u);
}

// Looks straight down on the floor y = 0 from 0.01 above the point (x, 0, 0), +x to the right:
// 8 columns are 0.0025 apart, the nearest to x by half of that.
Scene floor_at(double x) {
    Scene scene = one_pixel({x, 0.01, 0}, {x, 0, 0});
    scene.camera.up = {0, 0, -1};
    scene.camera.fov = 90;
    scene.width = 8;
    add_plane(scene, {0, 1, 0}, {0, 0, 0}, diffuse(white));
    return scene;
}

// `lit` says how light the floor is at an x.
template <typename Lit> void expect_shadow_on_the_left(const Image &image, double x, Lit lit) {
    for (int column = 0; column < 8; ++column) {
        const double light = column < 4 ? 0 : lit(x + 0.0025 * (column - 3.5));
        expect_color(image, column, 0, dvec3(light));
    }
}

// A ball of radius 1 at the height 2 under a light at the height 4: the cone that touches it has
// the half angle asin(1/2) = 30 degrees, so the shadow on the floor ends at x = 4 tan 30. There
// r² = 16 + x² and the cosine is 4 / r: I cos / r² = 4 I / r³.
TEST_P(Stage02Shadow, OfAPointLightEndsOnTheTangentCone) {
    const double end = 4 * std::tan(glm::radians(30.0));
    Scene scene = floor_at(end);
    add_sphere(scene, {0, 2, 0}, 1, diffuse(white));
    add_point_light(scene, {0, 4, 0}, white, 16);
    const Frame frame = draw(stage, scene);
    expect_shadow_on_the_left(frame.image, end,
                              [](double x) { return 4 * 16 / std::pow(16 + x * x, 1.5); });
    EXPECT_EQ(frame.rays.shadow, 8u);
}

// Under light that comes straight down, the shadow of the ball is as wide as the ball.
TEST_P(Stage02Shadow, OfADirectionalLightEndsOnTheTangentCylinder) {
    Scene scene = floor_at(1);
    add_sphere(scene, {0, 2, 0}, 1, diffuse(white));
    add_directional_light(scene, {0, -1, 0}, white, 0.7);
    expect_shadow_on_the_left(draw(stage, scene).image, 1, [](double) { return 0.7; });
}

// The line to a light ends at the light: a ball above it does not shadow, one around it does,
// and so does a plane between.
TEST_P(Stage02Shadow, OfWhatStandsBehindALightIsNone) {
    Scene scene = floor_at(0);
    scene.width = 1;
    add_sphere(scene, {0, 2, 0}, 1, diffuse(white));
    add_point_light(scene, {0, 0.5, 0}, white, 0.25);
    expect_color(draw(stage, scene).image, 0, 0, white);
    scene.spheres[0].center.y = 0.5;
    scene.spheres[0].radius = 0.1;
    expect_color(draw(stage, scene).image, 0, 0, dvec3(0));
    scene.spheres[0].center.x = 5;
    add_plane(scene, {0, 1, 0}, {0, 0.25, 0}, diffuse(white));
    expect_color(draw(stage, scene).image, 0, 0, dvec3(0));
    scene.planes[1].point.y = 0.75;
    expect_color(draw(stage, scene).image, 0, 0, white);
}

// A shadow ray starts no farther off the floor than rounding moves a point there, here some 5e-6: a
// ball of the radius 1e-4 in its way, twice that off, is not jumped.
TEST_P(Stage02Shadow, OfWhatIsNextToTheFloorIsThere) {
    Scene scene = one_pixel({0, 10.01, 0}, {0, 10, 0});
    scene.camera.up = {0, 0, -1};
    add_plane(scene, {0, 1, 0}, {0, 10, 0}, diffuse(white));
    const double slant = std::sqrt(0.5);
    add_sphere(scene, {2e-4 * slant, 10 + 2e-4 * slant, 0}, 1e-4, diffuse(white));
    add_directional_light(scene, {-slant, -slant, 0}, white, 1);
    expect_color(draw(stage, scene).image, 0, 0, dvec3(0));
    scene.spheres[0].center.z = 1.5e-4;
    expect_color(draw(stage, scene).image, 0, 0, dvec3(slant));
}

}  // namespace
}  // namespace stagelight::render
