// SPDX-License-Identifier: MIT
// Stage 04 against answers worked out by hand.
#include "reference/layers.h"
#include "render/on_each_device.h"
#include "scene/radiance_bound.h"

namespace stagelight::render {
namespace {

class Stage04Beer : public OnEachDevice {};
class Stage04Energy : public OnEachDevice {};
class Stage04Media : public OnEachDevice {};
INSTANTIATE_TEST_SUITE_P(Devices, Stage04Beer, each_device(), device_name);
INSTANTIATE_TEST_SUITE_P(Devices, Stage04Energy, each_device(), device_name);
INSTANTIATE_TEST_SUITE_P(Devices, Stage04Media, each_device(), device_name);

constexpr auto stage = "04_refraction_beer";
constexpr double ior = 1.5, radius = 0.7;
constexpr double F = 0.04;  // ((1 - 1.5) / (1 + 1.5))²: what is reflected head-on
const dvec3 sky(0.3, 0.6, 0.9), absorption(0.1, 0.8, 2.0), c(0.95, 0.9, 0.6);

// A ball of glass in a world of one colour, seen along its axis.
Scene ball_ahead(dvec3 world, Material material) {
    Scene scene = one_pixel({0, 0, 3}, {0, 0, 0});
    scene.background = world;
    add_sphere(scene, {0, 0, 0}, radius, material);
    return scene;
}

// c F b is reflected at once, of depth 1. What goes in, c (1-F), crosses the ball weakened by
// T = exp(-2 r a) and at each far wall lets c (1-F) out and is reflected by q = c F T for the
// next crossing. The crossing number k = 1, 2, … is of depth k, and what it lets out of
// depth k + 1, so D bounces have D - 1 terms: (c (1-F))² T b (1 - q^(D-1)) / (1 - q).
TEST_P(Stage04Beer, AlongTheAxisIsATruncatedSeries) {
    Scene scene = ball_ahead(sky, glass(c, ior, absorption));
    const dvec3 T = glm::exp(-absorption * (2 * radius)), q = c * F * T;
    for (const int depth : {0, 2, 8}) {
        scene.max_depth = depth;
        const Frame frame = draw(stage, scene);
        const dvec3 terms = (1.0 - glm::pow(q, dvec3(std::max(depth - 1, 0)))) / (1.0 - q);
        const dvec3 through = (1 - F) * (1 - F) * c * c * T * sky * terms;
        expect_color(frame.image, 0, 0, (depth > 0 ? c * F * sky : dvec3(0)) + through);
        // At each wall one ray is reflected and one refracted, at the last both are dropped.
        EXPECT_EQ(frame.rays.reflection, unsigned(depth));
        EXPECT_EQ(frame.rays.refraction, unsigned(depth));
        EXPECT_EQ(frame.rays.dropped, 2u);
    }
}

// The paper's way: c (F + (1-F) T) b, of one bounce.
TEST_P(Stage04Beer, AlongTheAxisThePaperPassesOnce) {
    const Scene scene = ball_ahead(sky, glass(c, ior, absorption));
    RenderSettings settings = settings_of(scene);
    settings.max_depth = 1;
    settings.methods["interior"] = "paper";
    const Frame frame = renderer(stage, scene, settings).render();
    const dvec3 T = glm::exp(-absorption * (2 * radius));
    expect_color(frame.image, 0, 0, c * (F + (1 - F) * T) * sky);
    EXPECT_EQ(frame.rays.reflection, 1u);
    EXPECT_EQ(frame.rays.refraction, 1u);
    EXPECT_EQ(frame.rays.dropped, 0u);
}

// From the middle, b (1-F) c comes weakened by the way to the wall. With the depth of 1 the
// reflected rest meets the far wall and ends there.
TEST_P(Stage04Beer, FromTheMiddleHalfTheBallIsInTheWay) {
    Scene scene = ball_ahead(sky, glass(c, ior, absorption));
    scene.camera.position = {0, 0, 0};
    scene.camera.look_at = {0, 0, -1};
    scene.max_depth = 1;
    expect_color(draw(stage, scene).image, 0, 0,
                 c * (1 - F) * glm::exp(-absorption * radius) * sky);
}

// In a white world, what D bounces show of clear glass is all but what they cut off:
// 1 - (1 - F) F^(D-1), with F the share at that pixel, at most 0.05 up to 0.8 of the radius.
TEST_P(Stage04Energy, AClearBallInAWhiteWorldTurnsWhite) {
    Scene scene = ball_ahead({1, 1, 1}, glass({1, 1, 1}, ior, {0, 0, 0}));
    scene.width = scene.height = 9;
    // The eye is 3 away; to the corners of the view 0.8 of the radius is sqrt(1/2) on an axis.
    scene.camera.fov = 2 * glm::degrees(std::atan(0.8 * radius * std::sqrt(0.5) / 3));
    double darkest = 0;
    for (const auto &[depth, least] :
         {std::pair{1, 0.0399}, {2, 0.95}, {4, 0.999}, {16, 0.99999}}) {
        scene.max_depth = depth;
        double now = 2;
        for (const glm::vec3 &pixel : draw(stage, scene).image.pixels) {
            now = std::min(now, double(pixel.g));
            EXPECT_LE(pixel.g, 1 + few_roundings);
        }
        EXPECT_GE(now, least) << "at the depth " << depth;
        EXPECT_GT(now, darkest) << "at the depth " << depth;
        darkest = now;
    }
}

// The eye in the middle of the ball: of what runs to and fro, weakened by q = c F T each time, the
// part c (1-F) leaves at each wall, of depth 1, 2, …
TEST_P(Stage04Beer, AnEyeInsideSeesATruncatedSeries) {
    Scene scene = ball_ahead(sky, glass(c, ior, absorption));
    scene.camera.position = {0, 0, 0};
    scene.camera.look_at = {0, 0, -1};
    const dvec3 q = c * F * glm::exp(-absorption * (2 * radius));
    for (const int depth : {1, 2, 6}) {
        scene.max_depth = depth;
        expect_color(draw(stage, scene).image, 0, 0,
                     glm::exp(-absorption * radius) * (1 - F) * c * sky
                         * (1.0 - glm::pow(q, dvec3(depth))) / (1.0 - q));
    }
}

// One ray at a time, and packets.
TEST_P(Stage04Media, AreThereByPrecedence) {
    for (const char *each : {stage, "11_full_tracer"}) {
        for (const LayeredScene &it : layered_scenes()) {
            SCOPED_TRACE(std::string(each) + ", " + it.what);
            const Frame frame = draw(each, it.scene);
            const double cut_off = frame.rays.cut_off_weight * radiance_bound(it.scene);
            expect_color(frame.image, 0, 0, it.expected(),
                         few_roundings + std::sqrt(3.0) * cut_off);
        }
    }
}

// Of what goes into water without a shore comes back what no channel absorbs: the sky beyond it.
TEST_P(Stage04Media, WaterWithoutAShoreShowsTheSkyInWhatItDoesNotAbsorb) {
    Scene scene = one_pixel({0, 0, 3}, {0, 0, 0});
    scene.background = sky;
    add_plane(scene, {0, 0, 1}, {0, 0, 0}, glass(c, ior, {0.7, 0, 0.001}));
    for (const char *each : {stage, "11_full_tracer"}) {
        SCOPED_TRACE(each);
        expect_color(draw(each, scene).image, 0, 0, c * sky * (F + (1 - F) * dvec3(0, 1, 0)));
    }
}

// Into a thinner ball at 0.8 of its radius: sin₂ = 0.8 / 0.5 is above 1, so all is reflected, and
// no ray goes in.
TEST_P(Stage04Energy, ABubbleReflectsAllBeyondTheCriticalAngle) {
    Scene scene = ball_ahead(sky, glass(c, 0.5, {0, 0, 0}));
    scene.camera.position.x = scene.camera.look_at.x = 0.8 * radius;
    const Frame frame = draw(stage, scene);
    expect_color(frame.image, 0, 0, c * sky);
    EXPECT_EQ(frame.rays.reflection, 1u);
    EXPECT_EQ(frame.rays.refraction, 0u);
    EXPECT_EQ(frame.rays.dropped, 0u);
}

// The atomic sums of the ray counts come in any order; the picture and the sums do not.
TEST_P(Stage04Energy, TwoPicturesAreTheSameToTheBit) {
    Scene scene = ball_ahead(sky, glass(c, ior, absorption));
    scene.width = 37;
    scene.height = 23;
    add_plane(scene, {0, 1, 0}, {0, -radius, 0}, glossy(c, 0.3));
    add_point_light(scene, {1, 2, 3}, {1, 1, 1}, 8);
    Renderer same = renderer(stage, scene);
    const Frame first = same.render();
    for (const Frame &again : {same.render(), draw(stage, scene)}) {
        EXPECT_TRUE(first.image.pixels == again.image.pixels);
        EXPECT_EQ(first.rays.shadow, again.rays.shadow);
        EXPECT_EQ(first.rays.reflection, again.rays.reflection);
        EXPECT_EQ(first.rays.refraction, again.rays.refraction);
        EXPECT_EQ(first.rays.dropped, again.rays.dropped);
    }
}

}  // namespace
}  // namespace stagelight::render
