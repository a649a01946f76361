// SPDX-License-Identifier: MIT
#include "scene/mesh_surface.h"

#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "scene/distance.h"
#include "scene/glass_meshes.h"

namespace stagelight {
namespace {

using glm::dvec3;

constexpr TriangleCorners flat{dvec3(0, 0, 0), dvec3(4, 0, 0), dvec3(0, 4, 0)};

TEST(ClosestPoint, OfEachCornerEdgeAndTheFace) {
    EXPECT_EQ(closest_point(flat, {-1, -2, 3}), dvec3(0, 0, 0));
    EXPECT_EQ(closest_point(flat, {6, -1, 3}), dvec3(4, 0, 0));
    EXPECT_EQ(closest_point(flat, {-1, 6, 3}), dvec3(0, 4, 0));
    EXPECT_EQ(closest_point(flat, {1, -2, 3}), dvec3(1, 0, 0));
    EXPECT_EQ(closest_point(flat, {-2, 3, 3}), dvec3(0, 3, 0));
    EXPECT_EQ(closest_point(flat, {4, 2, -3}), dvec3(3, 1, 0));
    EXPECT_EQ(closest_point(flat, {1, 2, -3}), dvec3(1, 2, 0));
}

void expect_distance(const TriangleCorners &other, double is) {
    EXPECT_NEAR(distance(flat, other), is, 1e-14);
    EXPECT_NEAR(distance(other, flat), is, 1e-14);
}

TEST(TriangleDistance, OfAFaceAndACorner) {
    expect_distance({dvec3(1, 1, 2), dvec3(1, 1, 9), dvec3(2, 1, 9)}, 2);
}

TEST(TriangleDistance, OfTwoEdges) {
    // Past the middle of the long edge, upwards and outwards of it, askew.
    const dvec3 away = dvec3(1, 1, std::sqrt(2.0)) / 2.0;
    const dvec3 along = dvec3(1, 1, -std::sqrt(2.0)) / 4.0 + dvec3(-1, 1, 0);
    const dvec3 past = dvec3(2, 2, 0) + 2.0 * away;
    expect_distance({past - 3.0 * along, past + along, past + 9.0 * away}, 2);
    expect_distance({dvec3(5, -1, 0), dvec3(5, 1, 0), dvec3(9, 0, 0)}, 1);
    // Beside the lower edge, from far left to far right.
    expect_distance({dvec3(-9, -1, -9), dvec3(13, -1, 13), dvec3(-9, -20, 4)}, 1);
}

TEST(TriangleDistance, IsZeroWhereTheyCross) {
    expect_distance({dvec3(1, 1, -1), dvec3(1, 1, 1), dvec3(9, 9, 1)}, 0);
    expect_distance({dvec3(1, 1, -9), dvec3(1, 1.5, -9), dvec3(1, 1, 9)}, 0);
    expect_distance({dvec3(1, 1, 1), dvec3(1, 1, -1), dvec3(9, 9, -1)}, 0);
    expect_distance({dvec3(1, 1, 9), dvec3(1, 1.5, 9), dvec3(1, 1, -9)}, 0);
    expect_distance({dvec3(1, 0, 0), dvec3(1, -1, 0), dvec3(2, -1, 0)}, 0);
}

// A spike that passes the triangle by.
TEST(TriangleDistance, IsNotZeroBeside) {
    expect_distance({dvec3(-3, -4, -9), dvec3(-3, -4, 9), dvec3(-30, -40, 0)}, 5);
}

std::vector<std::uint32_t> all(const Scene &scene) {
    std::vector<std::uint32_t> triangles(scene.triangles.size());
    std::iota(triangles.begin(), triangles.end(), 0u);
    return triangles;
}

class SurfaceOf : public GlassMesh {};

TEST_F(SurfaceOf, ABallGoesRoundItsInsideOnce) {
    const Scene scene = load(ball(), "scale = 10\nposition = [3, 4, 5]\n");
    const MeshSurface surface(scene, all(scene));
    for (int i = 0; i < 200; ++i) {
        const double r = 0.1 * i, turn = 2.4 * i, height = std::cos(0.7 * i);
        const double side = std::sqrt(1 - height * height);
        const dvec3 point =
            dvec3(3, 4, 5) + r * dvec3(side * std::cos(turn), height, side * std::sin(turn));
        if (r < 9.5 || r > 10) {
            EXPECT_NEAR(surface.winding_number(point), r < 9.5 ? 1 : 0, 0.01) << r;
        }
        if (std::abs(r - 8.9) > 0.15 && std::abs(r - 10.9) > 0.15) {  // a facet is up to 0.1 lower
            EXPECT_EQ(surface.comes_within(1, point), r > 8.9 && r < 10.9) << r;
        }
    }
}

TEST_F(SurfaceOf, HalfASkyIsHalfATurn) {
    const Scene scene = load("v -1e6 -1e6 1\nv 1e6 -1e6 1\nv 1e6 1e6 1\nv -1e6 1e6 1\n"
                             "f 1 2 3\nf 1 3 4\n");
    const MeshSurface surface(scene, all(scene));
    EXPECT_NEAR(surface.winding_number({0, 0, 0}), 0.5, 1e-5);
    EXPECT_NEAR(surface.winding_number({9, 9, 2}), -0.5, 1e-5);
}

}  // namespace
}  // namespace stagelight
