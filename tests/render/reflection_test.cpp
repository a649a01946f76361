// SPDX-License-Identifier: MIT
// Stage 03 against answers worked out by hand.
#include "render/on_each_device.h"

namespace stagelight::render {
namespace {

class Stage03Mirror : public OnEachDevice {};
class Stage03Glossy : public OnEachDevice {};
INSTANTIATE_TEST_SUITE_P(Devices, Stage03Mirror, each_device(), device_name);
INSTANTIATE_TEST_SUITE_P(Devices, Stage03Glossy, each_device(), device_name);

constexpr auto stage = "03_reflection_glossy";
const dvec3 sky(0.3, 0.6, 0.9), white(1, 1, 1);

// Two mirrors at a right angle, x = 0 and z = 0, together turn (x, y, z) into (-x, y, -z): the way
// o + t d goes on as that, and meets the wall z = 5 where o.z + t d.z = -5. A light stands 1
// before that point, so that E = 3.
TEST_P(Stage03Mirror, CornerSendsARayBack) {
    const dvec3 o(2, 0.5, 4), d(-1, 0.25, -1.5);
    const double t = (-5 - o.z) / d.z;
    const dvec3 end(-(o.x + t * d.x), o.y + t * d.y, 5);
    const dvec3 red(0.9, 0.3, 0.3), green(0.3, 0.8, 0.4), paper(0.7, 0.6, 0.5);
    Scene scene = one_pixel(o, o + d);
    add_plane(scene, {1, 0, 0}, {0, 0, 0}, mirror(red));
    add_plane(scene, {0, 0, 1}, {0, 0, 0}, mirror(green));
    add_plane(scene, {0, 0, -1}, {0, 0, 5}, diffuse(paper));
    add_point_light(scene, end - dvec3(0, 0, 1), white, 3);
    const Frame frame = draw(stage, scene);
    expect_color(frame.image, 0, 0, red * green * paper * 3.0, 1e-4);
    EXPECT_EQ(frame.rays.reflection, 2u);
    EXPECT_EQ(frame.rays.shadow, 1u);
    EXPECT_EQ(frame.rays.dropped, 0u);
}

// Between two mirrors that face each other nothing is ever seen: each pixel's ray is reflected
// max_depth times, and then dropped.
TEST_P(Stage03Mirror, RaysBeyondTheDepthAreCountedAndAddNothing) {
    Scene scene = one_pixel({0, 0, 0}, {0, 0, -1});
    scene.background = white;
    scene.width = 9;
    scene.height = 5;
    add_plane(scene, {0, 0, 1}, {0, 0, -1}, mirror(white));
    add_plane(scene, {0, 0, -1}, {0, 0, 1}, mirror(white));
    for (const int depth : {0, 7}) {
        scene.max_depth = depth;
        const Frame frame = draw(stage, scene);
        EXPECT_EQ(frame.rays.primary, 45u);
        EXPECT_EQ(frame.rays.reflection, 45u * unsigned(depth));
        EXPECT_EQ(frame.rays.dropped, 45u);
        expect_color(frame.image, 4, 2, dvec3(0), 0);
    }
}

// A light half-way between two glossy walls, 1 before each, gives both E = I. Of a ray straight
// at one, hit number k adds (1 - s) c I (s c)^k, for k = 0 … max_depth: the geometric sum
// (1 - s) c I (1 - q^(max_depth + 1)) / (1 - q), q = s c.
TEST_P(Stage03Glossy, FacingWallsMakeAGeometricSum) {
    const dvec3 c(0.95, 0.8, 0.5), q = 0.75 * c;
    Scene scene = one_pixel({0, 0, 0.5}, {0, 0, -1});
    add_plane(scene, {0, 0, 1}, {0, 0, -1}, glossy(c, 0.75));
    add_plane(scene, {0, 0, -1}, {0, 0, 1}, glossy(c, 0.75));
    add_point_light(scene, {0, 0, 0}, white, 2);
    for (const int depth : {0, 1, 7, 64}) {
        scene.max_depth = depth;
        const Frame frame = draw(stage, scene);
        expect_color(frame.image, 0, 0,
                     0.25 * c * 2.0 * (1.0 - glm::pow(q, dvec3(depth + 1))) / (1.0 - q), 1e-4);
        EXPECT_EQ(frame.rays.reflection, unsigned(depth));
        EXPECT_EQ(frame.rays.shadow, unsigned(depth) + 1);
        EXPECT_EQ(frame.rays.dropped, 1u);
    }
}

// (1 - s) c E + s c b, from all diffuse to all mirror.
TEST_P(Stage03Glossy, BlendsDiffuseAndReflected) {
    const dvec3 c(0.9, 0.5, 0.2);
    for (const double s : {0.0, 0.25, 1.0}) {
        Scene scene = one_pixel({0, 1, 0}, {1, 0, 0});
        scene.background = sky;
        add_plane(scene, {0, 1, 0}, {0, 0, 0}, glossy(c, s));
        add_directional_light(scene, {0, -1, 0}, white, 2);
        expect_color(draw(stage, scene).image, 0, 0, (1 - s) * c * 2.0 + s * c * sky);
    }
}

}  // namespace
}  // namespace stagelight::render
