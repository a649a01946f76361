// SPDX-License-Identifier: MIT
// Stage 01 against answers worked out by hand: (1/2 + N/2) (1 - 0.2 line / (1 + t²/50)), where
// line = 1/2 - cos(2 pi t) / 2 is 0 at whole distances and 1 half-way between them.
#include "render/on_each_device.h"

namespace stagelight::render {
namespace {

class Stage01Normals : public OnEachDevice {};
INSTANTIATE_TEST_SUITE_P(Devices, Stage01Normals, each_device(), device_name);

constexpr auto stage = "01_primitives";

dvec3 shown(dvec3 normal, double t) {
    const double line = 0.5 - 0.5 * std::cos(2 * std::numbers::pi * t);
    return (0.5 + 0.5 * normal) * (1 - 0.2 * line / (1 + t * t / 50));
}

// A ball at the distance t, straight ahead: its normal faces the eye.
TEST_P(Stage01Normals, OfABallAhead) {
    for (const double t : {2.0, 2.5, 5.0, 5.25}) {
        Scene scene = one_pixel({0, 0, 0}, {0, 0, -1});
        add_sphere(scene, {0, 0, -t - 1}, 1, diffuse({1, 1, 1}));
        // At t = 2.5 the line darkens by 0.2 / 1.125.
        expect_color(draw(stage, scene).image, 0, 0, shown({0, 0, 1}, t));
    }
}

// From inside, the normal of the far wall is turned to the eye; of two hits the nearer one counts,
// whichever shape comes first.
TEST_P(Stage01Normals, FromInsideABallTowardsAPlane) {
    Scene scene = one_pixel({0, 0, 0}, {0, 0, -1});
    add_sphere(scene, {0, 0, 0}, 2.5, diffuse({1, 1, 1}));
    add_plane(scene, {0, 0.6, -0.8}, {0, 0, -3.25}, diffuse({1, 1, 1}));
    expect_color(draw(stage, scene).image, 0, 0, shown({0, 0, 1}, 2.5));
    scene.spheres[0].radius = 3.5;
    expect_color(draw(stage, scene).image, 0, 0, shown({0, -0.6, 0.8}, 3.25));
}

// fov = 90 degrees: the half width is 1, the half height h/w. In a picture of 3 columns the
// centres are at -2/3, 0 and 2/3; of 3 rows at w/h times 2, 0 and -2.
TEST_P(Stage01Normals, ThroughPixelsOffTheMiddle) {
    Scene scene = one_pixel({0, 0, 0}, {0, 0, -1});
    scene.camera.fov = 90;
    add_plane(scene, {0, 0, 1}, {0, 0, -2}, diffuse({1, 1, 1}));
    scene.width = 3;
    const Image row = draw(stage, scene).image;
    for (const int x : {0, 1, 2}) {
        const double right = (x - 1) * 2.0 / 3;
        expect_color(row, x, 0, shown({0, 0, 1}, 2 * std::sqrt(1 + right * right)));
    }
    // Only the upper pixel sees a wall on the left and above: x < 0 is on the left, y > 0 above.
    scene.width = 1;
    scene.height = 3;
    scene.background = {0.1, 0.2, 0.3};
    scene.planes[0].normal = {0, 1, 0};
    scene.planes[0].point = {0, 3, 0};
    const Image column = draw(stage, scene).image;
    expect_color(column, 0, 0, shown({0, -1, 0}, 1.5 * std::sqrt(5.0)));
    expect_color(column, 0, 1, scene.background);
    expect_color(column, 0, 2, scene.background);
}

TEST_P(Stage01Normals, CountPrimaryRaysAndNoOthers) {
    Scene scene = one_pixel({0, 0, 0}, {0, 0, -1});
    scene.width = 5;
    scene.height = 3;
    add_sphere(scene, {0, 0, -2}, 1, diffuse({1, 1, 1}));
    RenderSettings settings = settings_of(scene);
    settings.samples = 4;
    const RayTotals rays = renderer(stage, scene, settings).render().rays;
    EXPECT_EQ(rays.primary, 5u * 3 * 4);
    EXPECT_EQ(rays.shadow + rays.reflection + rays.refraction + rays.dropped, 0u);
}

}  // namespace
}  // namespace stagelight::render
