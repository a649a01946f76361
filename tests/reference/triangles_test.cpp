// SPDX-License-Identifier: MIT
// Rays and lines against triangles, one and many.
#include "reference/intersect.h"

#include "scenes.h"

namespace stagelight::reference {
namespace {

// Over the origin of z = 0; coordinates that halves and quarters hold exactly.
const Corners<double> right_angled{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

// Straight down on (x, y), u = x and v = y.
TEST(ReferenceStage05Triangle, GivesDistanceAndBarycentricCoordinates) {
    for (const double side : {1.0, -1.0}) {
        const auto hit =
            intersect_triangle(ray({0.25, 0.5, 3 * side}, {0, 0, -side}), right_angled);
        ASSERT_TRUE(hit) << "from side " << side;
        EXPECT_DOUBLE_EQ(hit->distance, 3);
        EXPECT_DOUBLE_EQ(hit->u, 0.25);
        EXPECT_DOUBLE_EQ(hit->v, 0.5);
    }
    const auto slanting = intersect_triangle(ray({0.25, 0.25 - 4, 3}, {0, 4, -3}), right_angled);
    ASSERT_TRUE(slanting);
    EXPECT_DOUBLE_EQ(slanting->distance, 5);
    EXPECT_NEAR(slanting->v, 0.25, 1e-15);
}

TEST(ReferenceStage05Triangle, EndsAtItsEdgesWhichBelongToIt) {
    for (const double side : {1.0, -1.0}) {
        const auto hits = [&](double x, double y) {
            return intersect_triangle(ray({x, y, 2 * side}, {0, 0, -side}), right_angled)
                .has_value();
        };
        for (const auto &[x, y] :
             {std::pair{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}, {0.5, 0.0}, {0.0, 0.5}, {0.5, 0.5}})
            EXPECT_TRUE(hits(x, y)) << x << ", " << y << " from side " << side;
        for (const auto &[x, y] :
             {std::pair{-1e-12, 0.5}, {0.5, -1e-12}, {0.5, 0.5 + 1e-12}, {2.0, 2.0}, {-1.0, -1.0}})
            EXPECT_FALSE(hits(x, y)) << x << ", " << y << " from side " << side;
    }
}

TEST(ReferenceStage05Triangle, IsNotHitBehindOrAlongItsPlane) {
    EXPECT_FALSE(intersect_triangle(ray({0.25, 0.25, 2}, {0, 0, 1}), right_angled));
    EXPECT_FALSE(intersect_triangle(ray({-1, 0.25, 0}, {1, 0, 0}), right_angled)) << "in its plane";
    EXPECT_FALSE(intersect_triangle(ray({-1, 0.25, 1}, {1, 0, 0}), right_angled)) << "parallel";
    EXPECT_FALSE(intersect_triangle(ray({0.25, 0.25, 0}, {0, 0, -1}), right_angled)) << "from it";
}

// No absolute threshold: a triangle of any size is hit, and where.
TEST(ReferenceStage05Triangle, IsHitAtAnySize) {
    Dice dice;
    for (double size = 1e6; size > 1e-9; size /= 10)
        for (int i = 0; i < 200; ++i) {
            const Corners<double> triangle{size * dice.in_cube(1), size * dice.in_cube(1),
                                           size * dice.in_cube(1)};
            const double u = dice.between(0.05, 0.45), v = dice.between(0.05, 0.45);
            const dvec3 target = (1 - u - v) * triangle.a + u * triangle.b + v * triangle.c;
            const dvec3 direction = dice.direction();
            const dvec3 normal = facing(triangle);
            if (std::abs(glm::dot(normal, direction)) < 0.05 * size * size)
                continue;  // grazing or a splinter
            const auto hit =
                intersect_triangle(ray(target - 3 * size * direction, direction), triangle);
            ASSERT_TRUE(hit) << "size " << size;
            EXPECT_NEAR(hit->distance / size, 3, 1e-12);
            EXPECT_NEAR(hit->u, u, 1e-12);
            EXPECT_NEAR(hit->v, v, 1e-12);
        }
}

// A ray aimed at an edge that two triangles share meets one of them at least, rounding or no.
TEST(ReferenceStage05Triangle, NoRayPassesBetweenNeighbours) {
    Dice dice;
    for (int i = 0; i < 20000; ++i) {
        const dvec3 a = dice.in_cube(1), b = dice.in_cube(1);
        const dvec3 eye = {dice.between(-1, 1), dice.between(-1, 1), 5};
        const dvec3 target = glm::mix(a, b, dice.between(0.01, 0.99));
        const dvec3 aside = glm::cross(b - a, eye - target);
        const Corners<double> left{a, b, a + aside}, right{b, a, a - aside};
        const auto along = ray(eye, target - eye);
        EXPECT_TRUE(intersect_triangle(along, left) || intersect_triangle(along, right))
            << "at " << text(target) << " of " << text(a) << " to " << text(b);
    }
}

TEST(ReferenceStage05Triangle, ALineMeetsItOnlyBetweenItsEnds) {
    const auto meets = [](dvec3 from, dvec3 to) {
        return line_meets_triangle(Line<double>{from, to}, right_angled);
    };
    EXPECT_TRUE(meets({0.25, 0.25, 1}, {0.25, 0.25, -1}));
    EXPECT_TRUE(meets({0.25, 0.25, -1}, {0.25, 0.25, 1})) << "from below";
    EXPECT_TRUE(meets({0.5, 0, 1}, {0.5, 0, -1})) << "on an edge";
    EXPECT_FALSE(meets({0.25, 0.25, 1}, {0.25, 0.25, 0.001})) << "ends before";
    EXPECT_FALSE(meets({0.25, 0.25, -0.001}, {0.25, 0.25, -1})) << "starts beyond";
    EXPECT_FALSE(meets({0.75, 0.75, 1}, {0.75, 0.75, -1})) << "passes by";
}

Scene soup(int triangles) {
    Scene scene;
    scene.materials.emplace_back();
    Dice dice;
    for (int i = 0; i < triangles; ++i) {
        const dvec3 at = dice.in_cube(5);
        add_flat_triangle(scene, at, at + dice.in_cube(1), at + dice.in_cube(1));
    }
    return scene;
}

std::optional<double> nearest_of_all(const Scene &scene, const Ray<double> &along) {
    std::optional<double> nearest;
    for (const Triangle &triangle : scene.triangles) {
        const auto hit = intersect_triangle(along, corners_of<double>(scene, triangle));
        if (hit && (!nearest || hit->distance < *nearest))
            nearest = hit->distance;
    }
    return nearest;
}

TEST(ReferenceStage05Meshes, TheTreeOfTrianglesLosesNone) {
    const Scene scene = soup(300);
    const World<double> world(scene);
    Dice dice;
    for (int i = 0; i < 3000; ++i) {
        const auto along = ray(dice.in_cube(6), dice.direction());
        const auto expected = nearest_of_all(scene, along);
        const auto hit = world.closest_hit(along);
        ASSERT_EQ(hit.has_value(), expected.has_value()) << text(along.origin);
        EXPECT_EQ(world.blocked(along), expected.has_value());
        if (!expected)
            continue;
        EXPECT_EQ(hit->distance, *expected);
        const auto up_to = [&](double share) {
            return Line<double>{along.origin, along.origin + share * *expected * along.direction};
        };
        EXPECT_TRUE(world.blocked(up_to(1.001)));
        EXPECT_FALSE(world.blocked(up_to(0.999)));
    }
}

// Corners in a row, as modelling leaves them behind. Rounding would have rays meet it, and its
// normal is no number.
TEST(ReferenceStage05Meshes, ATriangleWithoutAnAreaIsNotThere) {
    Scene scene;
    const int material = add_material(scene, {});
    add_triangle(scene, {{0, 0, 0}, {0, 1, 0}, {}}, {{1, 0, 0}, {0, 1, 0}, {}},
                 {{2, 0, 0}, {0, 1, 0}, {}}, material);
    const World<double> world(scene);
    Dice dice;
    for (int i = 0; i < 3000; ++i) {
        const dvec3 origin = dice.in_cube(3), target(dice.between(0, 2), 0, 0);
        EXPECT_FALSE(world.closest_hit(ray(origin, target - origin))) << text(origin);
    }
}

}  // namespace
}  // namespace stagelight::reference
