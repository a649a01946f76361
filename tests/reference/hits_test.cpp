// SPDX-License-Identifier: MIT
// Rays and lines against spheres and planes.
#include "reference/intersect.h"

#include "scenes.h"

namespace stagelight::reference {
namespace {

constexpr double none = -1;

double sphere_distance(dvec3 origin, dvec3 direction, dvec3 center = {0, 0, 0}, double radius = 1) {
    return intersect_sphere(ray(origin, direction), center, radius).value_or(none);
}

// A ray that passes the centre of a unit sphere at the distance p from D away meets it at
// D ∓ sqrt(1 - p²); p = 0.6 makes that 0.8.
TEST(ReferenceStage01Sphere, HitsWhereTheClosedFormSays) {
    EXPECT_DOUBLE_EQ(sphere_distance({0, 0, 5}, {0, 0, -1}), 4);
    EXPECT_DOUBLE_EQ(sphere_distance({0.6, 0, 5}, {0, 0, -1}), 4.2);
    EXPECT_DOUBLE_EQ(sphere_distance({0, 0, 0}, {3, 2, 1}), 1) << "from the centre";
    EXPECT_DOUBLE_EQ(sphere_distance({0.6, 0, 0}, {0, 0, -1}), 0.8) << "from inside";
    EXPECT_DOUBLE_EQ(sphere_distance({0.6, 0, 0.5}, {0, 0, -1}), 1.3) << "from inside";
    EXPECT_DOUBLE_EQ(sphere_distance({0, 0, 1}, {0, 0, -1}), 2) << "from the surface, inwards";
    EXPECT_EQ(sphere_distance({0, 0, 1}, {0, 0, 1}), none) << "from the surface, outwards";
    EXPECT_EQ(sphere_distance({0, 0, 5}, {0, 0, 1}), none) << "behind";
    EXPECT_DOUBLE_EQ(sphere_distance({1, 0, 5}, {0, 0, -1}), 5) << "a tangent touches";
    EXPECT_EQ(sphere_distance({1 + 1e-15, 0, 5}, {0, 0, -1}), none) << "just beside";
    EXPECT_DOUBLE_EQ(sphere_distance({4, 0.6 * 7, 9}, {0, 0, -1}, {4, 0, -3}, 7), 12 - 0.8 * 7);
}

// Ten million radii away the rounded inputs alone shift the hit by about 1e7 * 2e-16; what the
// function adds to that shows against long double on the same inputs. (b² - c would be off by
// hundredths, and would miss.)
TEST(ReferenceStage01Sphere, IsPreciseFromTenMillionRadii) {
    Dice dice;
    for (int i = 0; i < 2000; ++i) {
        const dvec3 direction = dice.direction();
        const dvec3 aside = glm::normalize(glm::cross(direction, dice.direction()));
        const double p = dice.between(0, 0.95);
        const dvec3 origin = -1e7 * direction + p * aside;
        const double is = sphere_distance(origin, direction);
        const auto truth =
            intersect_sphere(ray<long double>(origin, direction), Vec<long double>(0), 1.0L);
        ASSERT_TRUE(truth);
        EXPECT_NEAR(is, double(*truth), 3e-8) << "p = " << p;
        EXPECT_NEAR(double(*truth), 1e7 - std::sqrt(1 - p * p), 3e-8) << "p = " << p;
    }
}

// A hit's point is put back on its sphere, so that rays from there start on the right side.
TEST(ReferenceStage01Sphere, PointsStayOnTheSurfaceFromAfar) {
    Scene scene;
    add_sphere(scene, {0, 0, 0}, 1, {});
    const RayTree tree = met(scene, ray({0.6, 0, 1e7}, {0, 0, -1}));
    EXPECT_NEAR(glm::length(tree.point), 1, 1e-15);
    expect_near(tree.shading_normal, {0.6, 0, 0.8}, 3e-9);
}

TEST(ReferenceStage01Plane, HitsWhereTheClosedFormSays) {
    const auto distance = [](dvec3 origin, dvec3 direction) {
        return intersect_plane(ray(origin, direction), {0, 1, 0}, {7, -2, 3}).value_or(none);
    };
    EXPECT_DOUBLE_EQ(distance({0, 4, 0}, {0, -1, 0}), 6);
    EXPECT_DOUBLE_EQ(distance({0, 4, 0}, {0.6, -0.8, 0}), 6 / 0.8);
    EXPECT_DOUBLE_EQ(distance({0, -4, 0}, {0, 0.8, 0.6}), 2 / 0.8) << "from below";
    EXPECT_EQ(distance({0, 4, 0}, {0, 1, 0}), none) << "behind";
    EXPECT_EQ(distance({0, 4, 0}, {1, 0, 0}), none) << "along the plane";
    EXPECT_EQ(distance({5, -2, 1}, {1, 0, 0}), none) << "in the plane";
    EXPECT_EQ(distance({5, -2, 1}, {0, -1, 0}), none) << "from the surface";
}

TEST(ReferenceStage01Line, MeetsASphereOnlyBetweenItsEnds) {
    const auto meets = [](dvec3 from, dvec3 to) {
        return line_meets_sphere(Line<double>{from, to}, {0, 0, 0}, 1.0);
    };
    EXPECT_TRUE(meets({0, 0, 5}, {0, 0, -5})) << "through";
    EXPECT_TRUE(meets({0, 0, 5}, {0, 0, 0})) << "into";
    EXPECT_TRUE(meets({0, 0, 0}, {0, 5, 0})) << "out of";
    EXPECT_TRUE(meets({1, 0, 5}, {1, 0, -5})) << "touches";
    EXPECT_FALSE(meets({0, 0, 5}, {0, 0, 1.001})) << "ends before";
    EXPECT_FALSE(meets({0, 0, -1.001}, {0, 0, -5})) << "starts beyond";
    EXPECT_FALSE(meets({0, 0, 0.5}, {0, 0.5, -0.5})) << "stays inside";
    EXPECT_FALSE(meets({1.001, 0, 5}, {1.001, 0, -5})) << "passes by";
}

TEST(ReferenceStage01Line, MeetsAPlaneOnlyBetweenItsEnds) {
    const auto meets = [](dvec3 from, dvec3 to) {
        return line_meets_plane(Line<double>{from, to}, {0, 1, 0}, {0, -2, 0});
    };
    EXPECT_TRUE(meets({0, 1, 0}, {5, -3, 0}));
    EXPECT_TRUE(meets({5, -3, 0}, {0, 1, 0})) << "from below";
    EXPECT_FALSE(meets({0, 1, 0}, {5, -1.999, 0})) << "ends before";
    EXPECT_FALSE(meets({0, -2.001, 0}, {5, -3, 0})) << "starts beyond";
    EXPECT_FALSE(meets({0, 1, 0}, {5, -2, 0})) << "ends on it, as a lamp may";
    EXPECT_FALSE(meets({0, 1, 0}, {5, 1, 0})) << "runs along it";
}

// A ray is an endless line: they agree when the line is longer than anything.
TEST(ReferenceStage01Line, AgreesWithARayOverALongWay) {
    Dice dice;
    for (int i = 0; i < 5000; ++i) {
        const auto along = ray(dice.in_cube(2), dice.direction());
        const Line<double> line{along.origin, along.origin + 100.0 * along.direction};
        EXPECT_EQ(line_meets_sphere(line, {0, 0, 0}, 1.0),
                  intersect_sphere(along, {0, 0, 0}, 1.0).has_value())
            << text(along.origin) << " towards " << text(along.direction);
    }
}

}  // namespace
}  // namespace stagelight::reference
