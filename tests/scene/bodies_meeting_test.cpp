// SPDX-License-Identifier: MIT
// Which bodies share a point, and which hold one.
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "scene/bodies.h"
#include "scene/glass_meshes.h"
#include "scene/glass_shapes.h"

namespace stagelight {
namespace {

class BodiesMeet : public GlassShapes {
protected:
    bool meet(const std::string &shapes) const {
        const Bodies bodies = bodies_of(load(shapes));
        EXPECT_EQ(bodies.list.size(), 2u) << shapes;
        EXPECT_LE(bodies.meeting.size(), 1u);
        return bodies.meeting == std::vector<std::pair<int, int>>{{0, 1}};
    }
    void expect_meeting(const std::vector<std::string> &all, bool do_meet) const {
        for (const std::string &shapes : all) {
            EXPECT_EQ(meet(shapes), do_meet) << shapes;
        }
    }
};

TEST_F(BodiesMeet, SpheresAndHalfSpaces) {
    expect_meeting({sphere("0, 0, 0", 1) + sphere("1.5, 0, 0", 1),
                    sphere("0, 0, 0", 1) + sphere("3, 0, 0", 2),
                    sphere("0, 0, 0", 1) + sphere("0.1, 0, 0", 3),
                    plane("0, 1, 0", "0, 0, 0") + sphere("0, 1, 0", 1),
                    plane("0, 1, 0", "0, 0, 0") + sphere("0, -9, 0", 1),
                    plane("0, 1, 0", "0, 0, 0") + plane("0, 1, 0", "0, 3, 0"),
                    plane("0, 1, 0", "0, 0, 0") + plane("0, -1, 0", "0, -1, 0"),
                    plane("0, 1, 0", "0, 0, 0") + plane("0, -1, 1e-3", "0, 1, 0")},
                   true);
    // The boxes of the first two overlap.
    expect_meeting({sphere("0, 0, 0", 1) + sphere("1.42, 1.42, 0", 1),
                    sphere("0, 0, 0", 1) + sphere("3.001, 0, 0", 2),
                    plane("0, 1, 0", "0, 0, 0") + sphere("0, 1.001, 0", 1),
                    plane("0, 1, 0", "0, 0, 0") + plane("0, -1, 0", "0, 0.001, 0")},
                   false);
}

// Sums of decimals are rounded up or down.
TEST_F(BodiesMeet, WhereTheyTouch) {
    folder.write("cube.obj", cube(false));
    for (int i = 1; i < 30; ++i) {
        const double r = 0.1 * i;
        expect_meeting(
            {sphere("0.3, 0, 0", r) + sphere(fmt::format("{:.3f}, 0, 0", 1 + r), 0.7),
             sphere(fmt::format("0, {:.3f}, 0", 0.3 + r), r) + plane("0, 1, 0", "0, 0.3, 0"),
             mesh("cube.obj", "0.3, 0, 0") + sphere(fmt::format("{:.3f}, 0, 0", 1.3 + r), r)},
            true);
    }
}

TEST_F(BodiesMeet, MeshesAndOthers) {
    folder.write("cube.obj", cube(false));
    expect_meeting(
        {mesh("cube.obj") + sphere("0, 0, 0", 0.2), mesh("cube.obj") + sphere("0, 0, 0", 9),
         mesh("cube.obj") + sphere("2, 0, 0", 1), mesh("cube.obj") + sphere("1, 1, 1", 0.1),
         mesh("cube.obj") + plane("0, 1, 0", "0, 0.5, 0"),
         mesh("cube.obj") + plane("0, 1, 0", "0, 9, 0"),
         mesh("cube.obj") + plane("0, 1, 0", "0, -1, 0")},
        true);
    expect_meeting({mesh("cube.obj") + sphere("1.7, 1.7, 0", 0.95),
                    mesh("cube.obj") + plane("0, 1, 0", "0, -1.001, 0")},
                   false);
}

TEST_F(BodiesMeet, Meshes) {
    folder.write("cube.obj", cube(false));
    folder.write("wedge.obj", pyramid);
    const std::string turned = "rotation = [0, 0, 180]\n";
    expect_meeting(
        {mesh("cube.obj") + mesh("cube.obj", "1.5, 1.5, 1.5"),
         mesh("cube.obj") + mesh("cube.obj", "2, 0, 0"),
         mesh("cube.obj") + mesh("cube.obj", "2, 2, 2"),
         mesh("cube.obj") + mesh("cube.obj", "0, 0, 0", "glass", "scale = 0.5\n"),
         mesh("cube.obj", "0, 0, 0", "glass", "scale = 0.5\n") + mesh("cube.obj"),
         // A bar through a cube, no corner of either in the other.
         mesh("cube.obj") + mesh("cube.obj", "0, 0, 0", "glass", "scale = [3, 0.3, 0.3]\n"),
         mesh("wedge.obj") + mesh("wedge.obj", "0.99, 0.99, 0", "glass", turned)},
        true);
    // The two wedges' boxes overlap, and a gap of 0.014 is between them.
    expect_meeting({mesh("cube.obj") + mesh("cube.obj", "2.001, 0, 0"),
                    mesh("wedge.obj") + mesh("wedge.obj", "1.01, 1.01, 0", "glass", turned)},
                   false);
}

TEST_F(BodiesMeet, NotInACavity) {
    folder.write("cube.obj", cube(false));
    folder.write("hollow.obj", cube(false) + cube(true, {0, 0, 0}, glm::dvec3(0.5), 8));
    expect_meeting({mesh("hollow.obj") + sphere("0, 0, 0", 0.4),
                    mesh("hollow.obj") + mesh("cube.obj", "0, 0, 0", "glass", "scale = 0.4\n")},
                   false);
    expect_meeting({mesh("hollow.obj") + sphere("0, 0, 0", 0.6),
                    mesh("hollow.obj") + sphere("0.75, 0, 0", 0.1),
                    mesh("hollow.obj") + mesh("cube.obj", "0, 0, 0", "glass", "scale = 0.6\n"),
                    mesh("hollow.obj") + mesh("cube.obj", "0, 0, 0", "glass", "scale = 2\n")},
                   true);
    // It fills the cavity, and can be seen there.
    EXPECT_TRUE(bodies_of(load(mesh("hollow.obj", "0, 0, 0", "hard")
                               + mesh("cube.obj", "0, 0, 0", "glass", "scale = 0.6\n")))
                    .warnings.empty());
}

TEST_F(BodiesMeet, InPairs) {
    const Bodies bodies =
        bodies_of(load(sphere("0, 0, 0", 5) + sphere("0, 0, 0", 4) + sphere("9, 0, 0", 3)
                       + sphere("6, 0, 0", 2) + plane("0, 1, 0", "0, -4.5, 0")));
    EXPECT_EQ(bodies.meeting,
              (std::vector<std::pair<int, int>>{{0, 1}, {1, 2}, {1, 4}, {2, 4}, {3, 4}}));
}

class BodiesAt : public GlassShapes {
protected:
    // By the lines of their shapes, the last one is what is there.
    std::vector<unsigned> held(const std::string &shapes, const glm::dvec3 &point) {
        const Scene scene = load(shapes);
        const Bodies bodies = bodies_of(scene);
        warnings.clear();
        std::vector<unsigned> lines;
        for (const int index : bodies_at(scene, bodies, point, &warnings)) {
            lines.push_back(bodies.list[static_cast<std::size_t>(index)].where.line);
        }
        EXPECT_EQ(bodies_at(scene, bodies, point).size(), lines.size());
        return lines;
    }
    void expect_told(const std::string &what) const {
        ASSERT_EQ(warnings.size(), 1u);
        EXPECT_NE(warnings[0].find(what), std::string::npos) << warnings[0];
    }
    std::vector<std::string> warnings;
};

using Lines = std::vector<unsigned>;

TEST_F(BodiesAt, SpheresAndHalfSpaces) {
    const std::string shapes =
        sphere("0, 0, 0", 1) + sphere("0, 0, 0", 3) + plane("1, 0, 0", "-1, 0, 0");
    EXPECT_EQ(held(shapes, {0.9, 0, 0}), (Lines{13, 9}));
    EXPECT_EQ(held(shapes, {1.1, 0, 0}), (Lines{13}));
    EXPECT_EQ(held(shapes, {3.1, 0, 0}), (Lines{}));
    EXPECT_EQ(held(shapes, {-1.1, 0, 0}), (Lines{17, 13}));
    EXPECT_EQ(held(shapes, {-50, 7, 0}), (Lines{17}));
    EXPECT_TRUE(warnings.empty());
}

TEST_F(BodiesAt, MeshesAndTheirCavities) {
    folder.write("hollow.obj", cube(false) + cube(true, {0, 0, 0}, glm::dvec3(0.5), 8));
    const std::string shapes = mesh("hollow.obj", "1, 0, 0", "glass", "scale = [-2, 1, 1]\n");
    EXPECT_EQ(held(shapes, {1, 0, 0}), (Lines{}));
    EXPECT_EQ(held(shapes, {1, 0.75, 0}), (Lines{10}));
    EXPECT_EQ(held(shapes, {2.9, 0.9, 0.9}), (Lines{10}));
    EXPECT_EQ(held(shapes, {3.1, 0, 0}), (Lines{}));
    EXPECT_TRUE(warnings.empty());
}

// Off by no more than a thousandth of the grid.
TEST_F(BodiesAt, AFineMesh) {
    folder.write("ball.obj", ball());
    const Scene scene = load(mesh("ball.obj"));
    const Bodies bodies = bodies_of(scene);
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 point(-1.2 + 0.24 * (i % 10) + 0.1, -1.2 + 0.24 * (i / 10 % 10) + 0.1,
                               -1.2 + 0.24 * (i / 100) + 0.1);
        const double r = glm::length(point);
        if (r < 0.95 || r > 1) {
            EXPECT_EQ(bodies_at(scene, bodies, point).size(), r < 0.95 ? 1u : 0u) << r;
        }
    }
}

TEST_F(BodiesAt, NotOnASurface) {
    folder.write("cube.obj", cube(false));
    const std::string told =
        " the eye lies on the surface of this dielectric; it is taken to be outside";
    EXPECT_EQ(held(sphere("0, 0, 0", 3), {0, 0, 3}), (Lines{}));
    expect_told("scene.toml:9:1:" + told);
    EXPECT_EQ(held(plane("0, 1, 0", "0, 0, 0"), {7, 0, 3}), (Lines{}));
    expect_told(told);
    EXPECT_EQ(held(plane("0.6, 0, 0.8", "3, 0, 4"), {5, 2, 2.5}), (Lines{}));
    expect_told(told);
    EXPECT_EQ(held(mesh("cube.obj"), {1, 0.3, 0.2}), (Lines{}));
    expect_told("scene.toml:10:8:" + told);
    EXPECT_EQ(held(mesh("cube.obj"), {0.9999, 0.3, 0.2}), (Lines{10}));
    EXPECT_TRUE(warnings.empty());
}

// The solid angle of one of six faces is missing.
TEST_F(BodiesAt, InAMeshWithAHole) {
    folder.write("box.obj", corners({0, 0, 0}, {1, 1, 1}) + faces(false).substr(2 * 8));
    const std::string told = ": this dielectric has holes, so whether the eye is inside can't be "
                             "told; it is taken to be ";
    EXPECT_EQ(held(mesh("box.obj"), {0, 0, 0}), (Lines{10}));
    expect_told("scene.toml:10:8" + told
                + "inside, since 83 % of what it sees around it is this mesh");
    EXPECT_EQ(held(mesh("box.obj"), {0, 0, -0.999}), (Lines{10}));
    EXPECT_EQ(held(mesh("box.obj"), {0, 0, -1.01}), (Lines{}));
    EXPECT_EQ(held(mesh("box.obj"), {0, 0, 7}), (Lines{}));
    EXPECT_TRUE(warnings.empty());
}

}  // namespace
}  // namespace stagelight
