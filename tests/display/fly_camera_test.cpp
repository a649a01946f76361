// SPDX-License-Identifier: MIT
#include "display/fly_camera.h"

#include <cmath>
#include <cstring>
#include <random>

#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include "scene/normalize.h"

namespace stagelight {
namespace {

constexpr double scene_size = 10;  // so 2 units a second at first
constexpr double second = 1;

const CameraDescription start = {{0, 1, 4}, {0, 0.5, -0.0}, {0, 1, 0}, 60};

Input with(bool Input::*key) {
    Input input;
    input.*key = true;
    return input;
}

Input looking(double right, double down) {
    Input input;
    input.look = {right, down};
    return input;
}

glm::dvec3 view(const CameraDescription &camera) {
    return normalize(camera.look_at - camera.position);
}

double pitch(const CameraDescription &camera) {
    return glm::degrees(std::asin(glm::dot(view(camera), normalize(camera.up))));
}

bool same_bits(const CameraDescription &a, const CameraDescription &b) {
    static_assert(sizeof(CameraDescription) == 10 * sizeof(double));
    return std::memcmp(&a, &b, sizeof a) == 0;
}

// The way of a camera while `input` lasts `seconds`, after the key was found pressed.
glm::dvec3 way(const CameraDescription &from, const Input &input, double seconds, int steps = 1) {
    FlyCamera camera(from, scene_size);
    camera.update(input, 0);
    for (int i = 0; i < steps; ++i) {
        camera.update(input, seconds / steps);
    }
    return camera.camera().position - from.position;
}

void expect_near(const glm::dvec3 &a, const glm::dvec3 &b, double most = 1e-12) {
    EXPECT_LE(glm::length(a - b), most)
        << a.x << " " << a.y << " " << a.z << ", expected " << b.x << " " << b.y << " " << b.z;
}

TEST(FlyCamera, IsTheScenesUntilSomethingIsPressed) {
    FlyCamera camera(start, scene_size);
    Input scrolled;
    scrolled.scroll = 3;
    for (const Input &input :
         {Input(), scrolled, with(&Input::reload), with(&Input::needs_redraw)}) {
        EXPECT_FALSE(camera.update(input, second));
        EXPECT_TRUE(same_bits(camera.camera(), start));
    }
}

TEST(FlyCamera, FliesAlongTheViewAndTheScenesUp) {
    const glm::dvec3 forward = view(start);
    const glm::dvec3 right(1, 0, 0);
    const glm::dvec3 up(0, 1, 0);
    expect_near(way(start, with(&Input::forward), second), 2.0 * forward);
    expect_near(way(start, with(&Input::back), second), -2.0 * forward);
    expect_near(way(start, with(&Input::right), second), 2.0 * right);
    expect_near(way(start, with(&Input::left), second), -2.0 * right);
    expect_near(way(start, with(&Input::up), second), 2.0 * up);
    expect_near(way(start, with(&Input::down), second), -2.0 * up);
}

TEST(FlyCamera, FliesNoFasterOnADiagonal) {
    Input input = with(&Input::forward);
    input.right = true;
    expect_near(way(start, input, second), std::sqrt(2.0) * (view(start) + glm::dvec3(1, 0, 0)));
}

TEST(FlyCamera, OppositeKeysCancel) {
    Input input = with(&Input::forward);
    input.back = true;
    FlyCamera camera(start, scene_size);
    EXPECT_FALSE(camera.update(input, second));
    EXPECT_TRUE(same_bits(camera.camera(), start));
}

TEST(FlyCamera, MovingTurnsNothing) {
    FlyCamera camera(start, scene_size);
    EXPECT_TRUE(camera.update(with(&Input::left), second));
    expect_near(view(camera.camera()), view(start));
    EXPECT_EQ(camera.camera().up, start.up);
    EXPECT_EQ(camera.camera().fov, start.fov);
}

TEST(FlyCamera, IsIndependentOfTheFrameRate) {
    for (const int steps : {1, 7, 60, 1000}) {
        expect_near(way(start, with(&Input::forward), second, steps), 2.0 * view(start));
    }
}

TEST(FlyCamera, ALongWaitBeforeAKeyIsNoFlight) {
    FlyCamera camera(start, scene_size);
    EXPECT_TRUE(camera.update(with(&Input::up), 3600 * second));
    EXPECT_LE(glm::distance(camera.camera().position, start.position), 0.1);
}

TEST(FlyCamera, LooksWhereTheMouseGoes) {
    FlyCamera camera(start, scene_size);
    EXPECT_TRUE(camera.update(looking(10, 0), 0));
    EXPECT_GT(view(camera.camera()).x, 0.01);
    EXPECT_NEAR(pitch(camera.camera()), pitch(start), 1e-9);
    FlyCamera other(start, scene_size);
    EXPECT_TRUE(other.update(looking(0, 10), 0));
    EXPECT_LT(pitch(other.camera()), pitch(start) - 0.1);
    EXPECT_NEAR(view(other.camera()).x, 0, 1e-12);
    for (const FlyCamera &any : {camera, other}) {
        EXPECT_EQ(any.camera().position, start.position);
        EXPECT_NEAR(glm::distance(any.camera().look_at, start.position),
                    glm::distance(start.look_at, start.position), 1e-12);
    }
}

TEST(FlyCamera, TurnsAllTheWayRound) {
    FlyCamera camera(start, scene_size);
    for (int i = 0; i < 240; ++i) {
        camera.update(looking(10, 0), 0);  // 1.5 degrees
    }
    expect_near(camera.camera().look_at, start.look_at, 1e-9);
}

TEST(FlyCamera, StopsShortOfThePoles) {
    for (const double way : {1e6, 100.0, -100.0, -1e6}) {
        FlyCamera camera(start, scene_size);
        for (int i = 0; i < 100; ++i) {
            camera.update(looking(0, way), 0);
        }
        EXPECT_NEAR(pitch(camera.camera()), way > 0 ? -89 : 89, 1e-6);
        camera.update(looking(50, 0), 0);
        EXPECT_NEAR(pitch(camera.camera()), way > 0 ? -89 : 89, 1e-6);
        camera.update(looking(0, way > 0 ? -100 : 100), 0);
        EXPECT_NEAR(pitch(camera.camera()), way > 0 ? -74 : 74, 1e-6) << "it gets away again";
    }
}

TEST(FlyCamera, ASteepStartStaysWhenLookingAside) {
    const CameraDescription steep = {{0, 5, 0}, {0, 0, -0.01}, {0, 1, 0}, 60};
    FlyCamera camera(steep, scene_size);
    camera.update(looking(1, 1), 0);
    EXPECT_NEAR(pitch(camera.camera()), pitch(steep), 1e-9);
}

TEST(FlyCamera, TakesAnyUp) {
    std::mt19937 random(1);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 100; ++i) {
        CameraDescription from;
        for (glm::dvec3 *any : {&from.position, &from.look_at, &from.up}) {
            *any = {normal(random), normal(random), normal(random)};
        }
        from.up *= 1e-3;
        FlyCamera camera(from, scene_size);
        camera.update(looking(123, 0), 0);
        EXPECT_NEAR(pitch(camera.camera()), pitch(from), 1e-6);
        camera.update(looking(-123, 0), 0);
        expect_near(camera.camera().look_at, from.look_at, 1e-9);
        expect_near(way(from, with(&Input::up), second), 2.0 * normalize(from.up));
        const glm::dvec3 aside = way(from, with(&Input::right), second);
        EXPECT_NEAR(glm::dot(aside, from.up), 0, 1e-12);
        EXPECT_NEAR(glm::dot(aside, view(from)), 0, 1e-12);
    }
}

TEST(FlyCamera, ScrollChangesTheSpeedByAFactorWithinBounds) {
    FlyCamera camera(start, scene_size);
    EXPECT_EQ(camera.speed(), 2);
    Input input;
    input.scroll = 1;
    camera.update(input, 0);
    const double factor = camera.speed() / 2;
    EXPECT_GT(factor, 1);
    camera.update(input, 0);
    EXPECT_NEAR(camera.speed(), 2 * factor * factor, 1e-12);
    input.scroll = -2;
    camera.update(input, 0);
    EXPECT_NEAR(camera.speed(), 2, 1e-12);
    for (const auto &[scroll, speed] : {std::pair(1e9, 2000.0), std::pair(-1e9, 0.002)}) {
        input.scroll = scroll;
        camera.update(input, 0);
        EXPECT_NEAR(camera.speed(), speed, 1e-9);
    }
}

TEST(FlyCamera, FliesAtTheSpeedScrolledTo) {
    FlyCamera camera(start, scene_size);
    Input input = with(&Input::up);
    input.scroll = 2;
    camera.update(input, 0);
    camera.update(with(&Input::up), second);
    EXPECT_NEAR(camera.camera().position.y - start.position.y, camera.speed(), 1e-12);
}

}  // namespace
}  // namespace stagelight
