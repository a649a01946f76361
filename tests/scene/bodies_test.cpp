// SPDX-License-Identifier: MIT
#include "scene/bodies.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "scene/glass_meshes.h"
#include "scene/glass_shapes.h"

namespace stagelight {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

using BodiesOf = GlassShapes;

std::vector<double> volumes(const Bodies &bodies) {
    std::vector<double> all;
    for (const Body &body : bodies.list) {
        all.push_back(body.volume);
    }
    return all;
}

TEST_F(BodiesOf, AreSpheresHalfSpacesAndPartsOfMeshes) {
    folder.write("two.obj", cube(false) + cube(false, {9, 0, 0}, glm::dvec3(0.5), 8));
    const Scene scene = load(sphere("0, 0, 0", 1, "paint") + sphere("5, 0, 0", 2)
                             + plane("0, 1, 0", "0, -4, 0") + plane("0, 1, 0", "0, -9, 0", "paint")
                             + mesh("two.obj", "0, 40, 0", "paint") + mesh("two.obj", "0, 20, 0"));
    const Bodies bodies = bodies_of(scene);
    ASSERT_EQ(bodies.list.size(), 4u);
    EXPECT_EQ(bodies.list[0].volume, endless);
    EXPECT_EQ(bodies.list[0].plane, 0);
    EXPECT_NEAR(bodies.list[1].volume, 4.0 / 3 * std::numbers::pi * 8, 1e-12);
    EXPECT_EQ(bodies.list[1].sphere, 1);
    EXPECT_NEAR(bodies.list[2].volume, 8, 1e-12);
    EXPECT_NEAR(bodies.list[3].volume, 1, 1e-12);
    EXPECT_EQ(bodies.list[3].triangles.size(), 12u);
    EXPECT_EQ(bodies.list[3].where.line, 30u);
    EXPECT_EQ(scene.materials[static_cast<std::size_t>(bodies.list[3].material)].type,
              MaterialType::dielectric);
    EXPECT_EQ(bodies.of_sphere, (std::vector<int>{-1, 1}));
    EXPECT_EQ(bodies.of_plane, (std::vector<int>{0, -1}));
    std::vector<int> of_triangle(48, -1);
    std::fill_n(of_triangle.begin() + 24, 12, 2);
    std::fill_n(of_triangle.begin() + 36, 12, 3);
    EXPECT_EQ(bodies.of_triangle, of_triangle);
}

TEST_F(BodiesOf, ACavityBelongsToTheBodyAroundIt) {
    folder.write("hollow.obj", cube(false) + cube(true, {0.1, 0.2, 0.3}, glm::dvec3(0.5), 8)
                                   + cube(false, {0.1, 0.2, 0.3}, glm::dvec3(0.25), 16));
    const Bodies bodies = bodies_of(load(mesh("hollow.obj")));
    ASSERT_EQ(bodies.list.size(), 2u);
    EXPECT_NEAR(bodies.list[0].volume, 7, 1e-6);
    EXPECT_EQ(bodies.list[0].triangles.size(), 24u);
    EXPECT_TRUE(bodies.list[0].is_closed);
    EXPECT_NEAR(bodies.list[1].volume, 0.125, 1e-6);
    EXPECT_TRUE(bodies.meeting.empty());
}

TEST_F(BodiesOf, HaveTheirTrianglesInOrder) {
    std::string text = corners({0, 0, 0}, {1, 1, 1}) + corners({0, 0, 0}, glm::dvec3(0.5));
    for (const auto &f : cube_faces) {
        text += face(f, false) + face(f, true, 8);
    }
    folder.write("hollow.obj", text);
    const Bodies bodies = bodies_of(load(mesh("hollow.obj")));
    ASSERT_EQ(bodies.list.size(), 1u);
    EXPECT_EQ(bodies.list[0].triangles.size(), 24u);
    EXPECT_TRUE(std::ranges::is_sorted(bodies.list[0].triangles));
}

TEST_F(BodiesOf, CubesThatTouchAtAnEdgeAreTwo) {
    folder.write("two.obj", cube(false) + cube(false, {2, 2, 0}, {1, 1, 1}, 8));
    EXPECT_EQ(volumes(bodies_of(load(mesh("two.obj")))), (std::vector<double>{8, 8}));
}

TEST_F(BodiesOf, HaveHolesAndAreBodies) {
    std::string holed = ball();
    folder.write("holed.obj", holed.substr(0, holed.rfind("f ")));
    const Bodies bodies = bodies_of(load(mesh("holed.obj")));
    ASSERT_EQ(bodies.list.size(), 1u);
    EXPECT_FALSE(bodies.list[0].is_closed);
    EXPECT_NEAR(bodies.list[0].volume, 4.0 / 3 * std::numbers::pi, 0.2);
}

// By line, since the file is where you say what comes later: spheres, planes and meshes may be
// mixed there.
std::vector<unsigned> lines(const Bodies &bodies) {
    std::vector<unsigned> all;
    for (const Body &body : bodies.list) {
        all.push_back(body.where.line);
    }
    return all;
}

TEST_F(BodiesOf, TheSmallerOneComesLaterThenTheOneBelowInTheFile) {
    folder.write("cube.obj", cube(false));
    EXPECT_EQ(
        lines(bodies_of(load(sphere("0, 0, 0", 1) + sphere("0, 0, 0", 3) + sphere("0, 0, 0", 2)))),
        (std::vector<unsigned>{13, 17, 9}));
    EXPECT_EQ(lines(bodies_of(load(plane("0, 1, 0", "0, 0, 0") + sphere("0, 0, 0", 1)
                                   + plane("1, 0, 0", "0, 0, 0")))),
              (std::vector<unsigned>{9, 17, 13}));
    // Equal but for rounding.
    for (const char *second : {"0.1, 0.7, 0.3", "10.1, 0.3, 0.9", "-0.7, 30.3, 0.1"}) {
        const std::string placing = "rotation = [10, 20, 30]\nscale = 0.3\n";
        EXPECT_EQ(lines(bodies_of(load(mesh("cube.obj", "9.7, 0.1, 0.2", "glass", placing)
                                       + mesh("cube.obj", second, "glass", placing)
                                       + mesh("cube.obj", "0, 0, 0", "glass", placing)))),
                  (std::vector<unsigned>{10, 16, 22}));
    }
    const std::string mixed = mesh("cube.obj", "0, 0, 0", "glass", "scale = 0.5\n")
                              + sphere("0, 0, 0", std::cbrt(0.75 / std::numbers::pi));
    EXPECT_EQ(lines(bodies_of(load(mixed))), (std::vector<unsigned>{10, 14}));
}

TEST_F(BodiesOf, PriorityComesFirst) {
    EXPECT_EQ(lines(bodies_of(load(sphere("0, 0, 0", 1, "soft") + sphere("0, 0, 0", 3, "hard")
                                   + sphere("0, 0, 0", 2) + plane("0, 1, 0", "0, 0, 0", "hard")))),
              (std::vector<unsigned>{9, 17, 21, 13}));
}

TEST_F(BodiesOf, TellOfAPriorityThatHides) {
    const auto told = [&](const std::string &shapes) { return bodies_of(load(shapes)).warnings; };
    folder.write("cube.obj", cube(false));
    const std::string here = (folder.path() / "scene.toml").string();
    EXPECT_EQ(told(sphere("0, 0, 0", 3, "hard") + sphere("0, 1, 0", 1, "soft")),
              (std::vector<std::string>{
                  here + ":13:1: this dielectric has priority -1 and lies wholly inside the one at "
                  + here
                  + ":9:1, which has priority 2, so it can't be seen; give it a higher "
                    "priority"}));
    const std::vector<std::string> hiding{
        mesh("cube.obj", "0, 0, 0", "hard") + sphere("0, 0, 0", 0.5),
        sphere("0, 0, 0", 2, "hard") + mesh("cube.obj"),
        plane("0, 1, 0", "0, 5, 0", "hard") + sphere("0, 0, 0", 2),
        plane("0, 1, 0", "0, 5, 0", "hard") + mesh("cube.obj"),
        plane("0, 1, 0", "0, 5, 0", "hard") + plane("0, 1, 0", "0, 4, 0"),
        mesh("cube.obj", "0, 0, 0", "hard") + mesh("cube.obj", "0, 0, 0", "soft", "scale = 0.5\n")};
    folder.write("drops.obj", cube(false, {1, 0, 0}, glm::dvec3(0.1))
                                  + cube(false, {-1, 0, 0}, glm::dvec3(0.1), 8));
    EXPECT_EQ(told(sphere("0, 0, 0", 3, "hard") + mesh("drops.obj")).size(), 1u);
    for (const std::string &shapes : hiding) {
        EXPECT_EQ(told(shapes).size(), 1u) << shapes;
    }
    const std::vector<std::string> seen{
        sphere("0, 0, 0", 3) + sphere("0, 1, 0", 1),
        sphere("0, 0, 0", 3, "soft") + sphere("0, 1, 0", 1),
        sphere("0, 0, 0", 3, "hard") + sphere("0, 3, 0", 1),
        plane("0, 1, 0", "0, 1, 0", "hard") + sphere("0, 0, 0", 2),
        mesh("cube.obj", "0, 0, 0", "hard") + mesh("cube.obj", "1, 0, 0", "soft"),
        sphere("0, 0, 0", 1.5, "hard") + mesh("cube.obj"),
        plane("0, 1, 0", "0, 5, 0", "hard") + plane("0, -1, 0", "0, 4, 0")};
    for (const std::string &shapes : seen) {
        EXPECT_TRUE(told(shapes).empty()) << shapes;
    }
}

}  // namespace
}  // namespace stagelight
