// SPDX-License-Identifier: MIT
// Refraction, Fresnel by Schlick, total internal reflection, and Beer's law.
#include "scenes.h"

namespace stagelight::reference {
namespace {

constexpr double ior = 1.5;
constexpr double at_normal = 0.04;  // ((1.5 - 1) / (1.5 + 1))²
const dvec3 sky(0.5, 0.7, 0.9);
const dvec3 up(0, 1, 0);

// A direction that comes down onto a floor at an angle to its normal.
dvec3 down_at(double angle) {
    return {std::sin(angle), -std::cos(angle), 0};
}

// n1 sin1 = n2 sin2, in the plane of incidence, and the way back is the way there.
TEST(ReferenceStage04Snell, BendsByTheRatioOfSines) {
    for (const double angle : {0.0, 0.3, 0.9, 1.5}) {
        const auto in = refract(down_at(angle), up, 1.0, ior);
        ASSERT_TRUE(in);
        const double inner = std::asin(std::sin(angle) / ior);
        expect_near(in->direction, down_at(inner), 1e-15);
        EXPECT_NEAR(in->cosine, std::cos(inner), 1e-15);
        const auto back = refract(-in->direction, -up, ior, 1.0);
        ASSERT_TRUE(back);
        expect_near(back->direction, -down_at(angle), 1e-14);
    }
}

TEST(ReferenceStage04Schlick, IsTheClosedFormAtItsEnds) {
    for (const double n : {1.1, 1.5, 2.4}) {
        const double expected = std::pow((n - 1) / (n + 1), 2);
        EXPECT_DOUBLE_EQ(schlick(1.0, n, 1.0, 1.0), expected);
        EXPECT_DOUBLE_EQ(schlick(n, 1.0, 1.0, 1.0), expected);
        EXPECT_DOUBLE_EQ(schlick(1.0, n, 0.0, 0.5), 1) << "grazing, from outside";
        EXPECT_DOUBLE_EQ(schlick(n, 1.0, 0.5, 0.0), 1) << "critical, from inside";
    }
    EXPECT_DOUBLE_EQ(schlick(1.0, ior, 0.5, 0.9), at_normal + (1 - at_normal) / 32);
}

// The same share both ways along one path.
TEST(ReferenceStage04Schlick, IsTheSameFromBothSides) {
    const double outer = std::cos(1.0), inner = std::cos(std::asin(std::sin(1.0) / ior));
    EXPECT_DOUBLE_EQ(schlick(1.0, ior, outer, inner), schlick(ior, 1.0, inner, outer));
}

// Beyond asin(1 / n) nothing leaves; on the way in, and just below that angle, something does.
TEST(ReferenceStage04Snell, AllIsReflectedBeyondTheCriticalAngle) {
    const double critical = std::asin(1 / ior);
    EXPECT_FALSE(refract(down_at(critical + 1e-9), up, ior, 1.0));
    EXPECT_TRUE(refract(down_at(critical - 1e-9), up, ior, 1.0));
    EXPECT_TRUE(refract(down_at(1.57), up, 1.0, ior));
}

// The half space below y = 0 is glass; in it, at y = -2, lies a lit floor. A ray that goes up at
// an angle from depth 1 meets the surface from behind. Beyond the critical angle it sees the floor
// by reflection alone, through 1 / cos of glass on the way up and 2 / cos on the way down.
TEST(ReferenceStage04Reflection, TotalInsideAndAbsorbedOnItsWay) {
    const double angle = std::asin(1 / ior) + 0.01;
    const dvec3 absorption(0.1, 0.5, 0), paint(0.9, 0.8, 0.7);
    Scene scene;
    scene.background = sky;
    add_plane(scene, up, {0, 0, 0}, glass({1, 1, 1}, ior, absorption));
    add_plane(scene, up, {0, -2, 0}, diffuse(paint));
    const double length = 2 / std::cos(angle);
    const dvec3 lamp(std::tan(angle) * 3, -1, 0);  // one above where the floor is met
    add_point_light(scene, lamp, {1, 1, 1}, 1);
    expect_near(seen(scene, ray({0, -1, 0}, -down_at(-angle))),
                paint * glm::exp(-absorption * (1.5 * length)), 1e-12);
}

// Just inside the critical angle both are seen: F · floor + (1 - F) · sky.
TEST(ReferenceStage04Reflection, PartialInsideTheCriticalAngle) {
    const double angle = 0.5;
    const double cos2 = std::cos(std::asin(ior * std::sin(angle)));
    const double F = at_normal + (1 - at_normal) * std::pow(1 - cos2, 5);
    Scene scene;
    scene.background = sky;
    add_plane(scene, up, {0, 0, 0}, glass({1, 1, 1}, ior, {}));
    add_plane(scene, up, {0, -2, 0}, diffuse({1, 1, 1}));
    add_point_light(scene, {std::tan(angle) * 3, -1, 0}, {1, 1, 1}, 1);
    expect_near(seen(scene, ray({0, -1, 0}, -down_at(-angle))), F * dvec3(1) + (1 - F) * sky,
                1e-12);
}

struct Ball {
    dvec3 color{1, 1, 1};
    dvec3 absorption{0.2, 1.0, 3.0};
    double radius = 0.7;
};

Scene ball_scene(const Ball &ball) {
    Scene scene;
    scene.background = sky;
    add_sphere(scene, {0, 0, 0}, ball.radius, glass(ball.color, ior, ball.absorption));
    return scene;
}

// What a ray that passes the ball's centre at the distance p sees.
dvec3 ball_at(const Scene &scene, double p, const Settings &settings) {
    return seen(scene, ray({p, 0, 3}, {0, 0, -1}), settings);
}

// A ray straight at a glass ball stays on the axis. With F the reflected share, T = exp(-a d)
// the transmittance of the diameter, b the background and c the material's colour, which each
// crossing multiplies in: the first reflection (depth 1) gives c F b. The refracted ray (depth 1)
// meets the far wall after T; what leaves there (depth 2) gives c(1-F) T c(1-F) b, and the rest
// goes back and forth, c F T each time, and at each wall lets out its part, one depth deeper.
// So with D = max_depth, D - 1 parts leave, and with q = c F T
//     c F b [D >= 1] + (c (1-F))² T b (1 - q^(D-1)) / (1 - q).
TEST(ReferenceStage04Beer, AnAxialRayThroughABallIsAGeometricSeries) {
    for (const Ball &ball : {Ball{}, Ball{.color = {0.9, 0.6, 1}}, Ball{.absorption = {0, 0, 0}}}) {
        const Scene scene = ball_scene(ball);
        const dvec3 c = ball.color, T = glm::exp(-ball.absorption * (2 * ball.radius));
        const double F = at_normal;
        for (const int depth : {0, 1, 2, 3, 4, 8, 64}) {
            const dvec3 q = c * F * T;
            const dvec3 series = (1.0 - glm::pow(q, dvec3(std::max(depth - 1, 0)))) / (1.0 - q);
            const dvec3 through = (1 - F) * (1 - F) * c * c * T * sky * series;
            expect_near(ball_at(scene, 0, {.max_depth = depth}),
                        (depth >= 1 ? c * F * sky : dvec3(0)) + through, 1e-13);
        }
    }
}

// The eye in the middle of the ball: what leaves at once, c (1-F) b, comes through half of it; the
// rest is reflected back through the whole ball.
TEST(ReferenceStage04Beer, AnEyeInsideABallSeesOutOfIt) {
    const Ball ball{.color = {0.9, 0.6, 1}};
    const dvec3 c = ball.color, T = glm::exp(-ball.absorption * (2 * ball.radius));
    const double F = at_normal;
    expect_near(seen(ball_scene(ball), ray({0, 0, 0}, {0, 0, -1}), {.max_depth = 64}),
                c * glm::sqrt(T) * (1 - F) * sky / (1.0 - c * F * T), 1e-13);
}

// Off the axis by p: sin1 = p / r, the chord is 2 r cos2, and the share F is the same at every
// wall: the same series with the chord for the diameter.
TEST(ReferenceStage04Beer, OffTheAxisTheChordCounts) {
    const Ball ball;
    for (const double share : {0.3, 0.7, 0.95}) {
        const double cos1 = std::sqrt(1 - share * share);
        const double cos2 = std::sqrt(1 - share * share / (ior * ior));
        const double F = at_normal + (1 - at_normal) * std::pow(1 - cos1, 5);
        const dvec3 T = glm::exp(-ball.absorption * (2 * ball.radius * cos2));
        expect_near(ball_at(ball_scene(ball), share * ball.radius, {.max_depth = 64}),
                    F * sky + (1 - F) * (1 - F) * T * sky / (1.0 - F * T), 1e-13);
    }
}

// F b + (1 - F) exp(-a · chord) b, times the colour once.
TEST(ReferenceStage04Beer, ThePapersInteriorIsASinglePass) {
    const Ball ball{.color = {0.9, 0.6, 1}};
    Scene scene = ball_scene(ball);
    // What stands inside is not seen.
    add_sphere(scene, {0, 0, 0}, 0.1, diffuse({1, 1, 1}));
    for (const double share : {0.0, 0.5, 0.99}) {
        const double cos1 = std::sqrt(1 - share * share);
        const double cos2 = std::sqrt(1 - share * share / (ior * ior));
        const double F = at_normal + (1 - at_normal) * std::pow(1 - cos1, 5);
        const dvec3 T = glm::exp(-ball.absorption * (2 * ball.radius * cos2));
        expect_near(
            ball_at(scene, share * ball.radius, {.max_depth = 1, .interior = Interior::paper}),
            ball.color * (F + (1 - F) * T) * sky, 1e-13);
    }
}

// The ray that leaves is bent by twice (angle1 - angle2) in all, and starts on the far wall. It
// meets the wall z = -2 there; the closed form is the ray from the far end of the chord.
TEST(ReferenceStage04Snell, BothInteriorsLeaveTheBallAtTheSamePlace) {
    const Ball ball;
    Scene scene = ball_scene(ball);
    add_plane(scene, {0, 0, 1}, {0, 0, -2}, diffuse({1, 1, 1}));
    const double angle1 = std::asin(0.5), angle2 = std::asin(0.5 / ior);
    const double bend = angle1 - angle2, chord = 2 * ball.radius * std::cos(angle2);
    const dvec3 in = ball.radius * dvec3(std::sin(angle1), 0, std::cos(angle1));
    const dvec3 out = in + chord * dvec3(-std::sin(bend), 0, -std::cos(bend));
    const dvec3 way(-std::sin(2 * bend), 0, -std::cos(2 * bend));
    const dvec3 expected = out + (-2 - out.z) / way.z * way;
    const auto along = ray({0.5 * ball.radius, 0, 3}, {0, 0, -1});
    const RayTree full = met(scene, along);
    expect_near(full.children.at(1).children.at(1).point, expected, 1e-12);
    const RayTree paper = met(scene, along, {.interior = Interior::paper});
    expect_near(paper.children.at(1).point, expected, 1e-12);
}

// The paper's eye inside the ball refracts out, once: c b, through half of the ball.
TEST(ReferenceStage04Beer, ThePapersEyeInsideSeesTheSkyAtOnce) {
    const Ball ball{.color = {0.9, 0.6, 1}};
    expect_near(seen(ball_scene(ball), ray({0, 0, 0}, {0, 0, -1}), {.interior = Interior::paper}),
                ball.color * glm::exp(-ball.absorption * ball.radius) * sky, 1e-15);
}

// What a refracted ray finds inside is weakened by the way to it alone: a mirror ball of
// radius 0.2 in the middle, 0.5 behind the wall, sends the ray back, weakened again, and F of
// that is reflected at the wall, to the mirror and back, and so on: with t = exp(-a 0.5) a series
// F + (1-F)² t² / (1 - F t²).
TEST(ReferenceStage04Beer, WhatStandsInsideIsSeenThroughTheGlassBeforeIt) {
    const Ball ball;
    Scene scene = ball_scene(ball);
    add_sphere(scene, {0, 0, 0}, 0.2, mirror({1, 1, 1}));
    const double F = at_normal;
    const dvec3 t2 = glm::exp(-ball.absorption * 1.0);
    expect_near(ball_at(scene, 0, {.max_depth = 64}),
                F * sky + (1 - F) * (1 - F) * t2 * sky / (1.0 - F * t2), 1e-13);
}

// Clear glass takes nothing away: F + (1-F)² (1 + F + F² + …) = 1, wherever the ball is met.
TEST(ReferenceStage04Energy, AClearBallInAWhiteWorldIsWhite) {
    Scene scene = ball_scene({.absorption = {0, 0, 0}});
    scene.background = {1, 1, 1};
    Dice dice;
    for (int i = 0; i < 300; ++i) {
        const double p = dice.between(0, 0.9 * 0.7);
        double before = 0;
        for (const int depth : {1, 2, 4, 16, 64}) {
            const double now = ball_at(scene, p, {.max_depth = depth}).x;
            EXPECT_GE(now, before) << "depth " << depth << ", p = " << p;
            before = now;
        }
        EXPECT_NEAR(before, 1, 1e-12) << "p = " << p;
    }
}

}  // namespace
}  // namespace stagelight::reference
