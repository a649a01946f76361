// SPDX-License-Identifier: MIT
#include "scene/orient.h"

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "scene/closed_mesh.h"
#include "scene/glass_meshes.h"

namespace stagelight {
namespace {

class Orient : public GlassMesh {};

TEST_F(Orient, LeavesWhatIsRight) {
    for (const std::string &obj : {cube(false), cube_with_normals(false, 1), ball(), leaning(1)}) {
        const Scene scene = load(obj);
        expect_same(scene, load(obj, "", "diffuse"));
        EXPECT_EQ(scene.warnings, std::vector<std::string>{});
    }
}

TEST_F(Orient, IsOfNoInterestToPaint) {
    const Scene scene = load(cube(true), "", "diffuse");
    EXPECT_NEAR(volume_of(scene), -8, 1e-12);
    EXPECT_LT(scene.vertices[scene.triangles[2].vertices[0]].normal.z, -0.9);
}

TEST_F(Orient, TurnsAClosedMeshOutwards) {
    const Scene scene = load(cube(true), "rotation = [10, 20, 30]\n");
    EXPECT_NEAR(volume_of(scene), 8, 1e-12);
    expect_agreeing_normals(scene);
    EXPECT_EQ(scene.vertices.size(), load(cube(false)).vertices.size());
}

// The normals that a file has are right though its triangles are not, or the other way round.
// Those that lean are turned with all others, or stay with them.
TEST_F(Orient, TurnsSingleFaces) {
    std::string obj = corners({0, 0, 0}, {1, 1, 1});
    for (std::size_t i = 0; i < cube_faces.size(); ++i) {
        obj += face(cube_faces[i], i == 2 || i == 3 || i == 7);
    }
    const Scene scene = load(obj);
    EXPECT_NEAR(volume_of(scene), 8, 1e-12);
    expect_agreeing_normals(scene);
}

// A ball's normals are made without the triangle that is the wrong way round, and it has its own.
TEST_F(Orient, DropsDoubledFaces) {
    const Scene scene = load(cube(true) + faces(false));
    EXPECT_EQ(scene.triangles.size(), 12u);
    EXPECT_NEAR(volume_of(scene), 8, 1e-12);
    expect_agreeing_normals(scene);
    EXPECT_EQ(open_dielectric_meshes(scene), std::vector<std::string>{});
    EXPECT_EQ(load(cube(false) + face(cube_faces[3], false)).triangles.size(), 12u) << "one face";
}

// Two cubes in one file that share a wall are one block.
TEST_F(Orient, DropsTheWallBetweenGlassAndGlass) {
    const Scene scene = load(cube(false) + cube(false, {2, 0, 0}, {-1, 1, 1}, 8));
    EXPECT_EQ(scene.triangles.size(), 20u);
    EXPECT_NEAR(volume_of(scene), 16, 1e-12);
    expect_agreeing_normals(scene);
    EXPECT_EQ(open_dielectric_meshes(scene), std::vector<std::string>{});
}

// But where their triangles divide it by different diagonals, both are closed, and touch.
TEST_F(Orient, TakesCubesThatTouchApart) {
    const std::string places = corners({0, 0, 0}, {1, 1, 1}) + corners({2, 0, 0}, {1, 1, 1});
    for (int way = 0; way < 8; ++way) {
        const bool is_first_in = (way & 1) != 0, is_second_in = (way & 2) != 0;
        const bool is_mixed = (way & 4) != 0;
        std::string text = places;
        for (const auto &f : cube_faces) {
            text += face(f, is_first_in) + (is_mixed ? face(f, is_second_in, 8) : "");
        }
        // Then nothing tells whose wall is whose.
        if (is_mixed && is_first_in != is_second_in) {
            continue;
        }
        const Scene scene = load(is_mixed ? text : text + faces(is_second_in, 8));
        ASSERT_EQ(scene.triangles.size(), 24u);
        for (std::size_t i = 0; i < 24; ++i) {
            const auto [a, b, c] = corners_of(scene, scene.triangles[i]);
            const glm::dvec3 center((is_mixed ? i % 2 == 0 : i < 12) ? 0 : 2, 0, 0);
            EXPECT_GT(glm::dot(a - center, glm::cross(b - a, c - a)), 0)
                << "triangle " << i << ", " << way;
        }
        expect_agreeing_normals(scene);
        EXPECT_EQ(open_dielectric_meshes(scene), std::vector<std::string>{});
        EXPECT_EQ(scene.warnings, std::vector<std::string>{});
    }
}

// They share an edge, and its ends: each is closed by itself.
TEST_F(Orient, TakesCubesThatTouchAtAnEdgeApart) {
    for (int way = 0; way < 16; ++way) {
        const glm::dvec3 center((way & 4) != 0 ? 2 : -2, (way & 8) != 0 ? 2 : -2, 0);
        const Scene scene = load(cube((way & 1) != 0) + cube((way & 2) != 0, center, {1, 1, 1}, 8));
        EXPECT_NEAR(volume_of(scene), 16, 1e-12) << way;
        expect_agreeing_normals(scene);
        EXPECT_EQ(open_dielectric_meshes(scene), std::vector<std::string>{});
        EXPECT_EQ(scene.warnings, std::vector<std::string>{});
    }
}

TEST_F(Orient, KeepsACavityACavity) {
    const auto nested = [](bool outer, bool inner) {
        return cube(outer) + cube(inner, {0.1, 0.2, 0.3}, glm::dvec3(0.5), 8);
    };
    EXPECT_NEAR(volume_of(load(nested(false, true))), 8 - 1, 1e-6);
    EXPECT_NEAR(volume_of(load(nested(true, false))), 8 - 1, 1e-6) << "the file is inside out";
    EXPECT_NEAR(volume_of(load(nested(false, false))), 8 + 1, 1e-6) << "glass in glass";
    EXPECT_NEAR(volume_of(load(nested(true, true))), 8 + 1, 1e-6);
    const std::string beside = cube(true, glm::dvec3(0.8), glm::dvec3(0.1), 4);
    EXPECT_NEAR(volume_of(load(pyramid + beside)), 1.0 / 6 + 0.008, 1e-6) << "in its box only";
    // A marble in the cavity, wound as the cavity's wall is, or the other way round.
    EXPECT_NEAR(
        volume_of(load(nested(false, true) + cube(true, {0, 0.2, 0.3}, glm::dvec3(0.25), 16))),
        8 - 1 + 0.125, 1e-6);
    EXPECT_NEAR(
        volume_of(load(nested(true, false) + cube(true, {0, 0.2, 0.3}, glm::dvec3(0.25), 16))),
        8 - 1 + 0.125, 1e-6);
    expect_agreeing_normals(load(nested(true, false)));
}

TEST_F(Orient, KeepsTheSideOfAMirroredMesh) {
    for (const std::string &obj :
         {cube(false), cube(true), cube_with_normals(false, 1), cube_with_normals(true, 1)}) {
        const Scene scene = load(obj, "scale = [-1, 2, 3]\nrotation = [10, 20, 30]\n");
        EXPECT_NEAR(volume_of(scene), 48, 1e-10);
        expect_agreeing_normals(scene);
    }
    expect_same(load(cube(false), "scale = [1, 1, -1]\n"),
                load(cube(false), "scale = [1, 1, -1]\n", "diffuse"));
}

// A ball with a small hole has an inside, wherever it lies. A sheet has none.
TEST_F(Orient, TurnsWhatIsNearlyClosed) {
    std::string holed = ball();
    holed = holed.substr(0, holed.rfind("f "));
    for (const std::string position :
         {"position = [0, 0, 0]\n", "position = [0, 1e4, 0]\n", "position = [0, -1e4, 0]\n"}) {
        expect_same(load(holed, position), load(holed, position, "diffuse"));
        expect_agreeing_normals(load(reversed(holed), position));
        EXPECT_NEAR(volume_of(load(reversed(holed), position)), volume_of(load(holed, position)),
                    1e-6);
    }
    const std::string sheet = "v 0 0 0\nv 1 0 0.1\nv 1 1 0\nv 0 1 0.1\nvn 0 0 -1\n"
                              "f 1//1 2//1 3//1\nf 1//1 3//1 4//1\n";
    for (const std::string &obj : {sheet, reversed(sheet)}) {
        expect_same(load(obj), load(obj, "", "diffuse"));
    }
}

void expect_unclear(const Scene &scene, int edges) {
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_NE(scene.warnings[0].find("scene.toml:7:8: "), std::string::npos) << scene.warnings[0];
    EXPECT_NE(scene.warnings[0].find(fmt::format(
                  "a.obj is a dielectric without a clear outside: at {} of its edges", edges)),
              std::string::npos)
        << scene.warnings[0];
}

TEST_F(Orient, TellsOfAMoebiusStrip) {
    std::string strip;
    for (int i = 0; i < 16; ++i) {
        const double turn = std::numbers::pi * i / 16;
        for (const int side : {-1, 1}) {
            const double r = 2 + side * 0.5 * std::cos(turn);
            strip += fmt::format("v {} {} {}\n", r * std::cos(2 * turn), r * std::sin(2 * turn),
                                 side * 0.5 * std::sin(turn));
        }
    }
    for (int i = 0; i < 16; ++i) {
        const bool is_last = i == 15;  // joined the other way round
        const int a = 2 * i + 1, b = a + 1, c = is_last ? 2 : a + 2, d = is_last ? 1 : a + 3;
        strip += fmt::format("f {} {} {}\nf {} {} {}\n", a, b, c, c, b, d);
    }
    expect_unclear(load(strip), 1);
}

TEST_F(Orient, TellsOfThreeTrianglesAtAnEdge) {
    expect_unclear(load(cube(false) + "f 1 2 7\n"), 2);
}

}  // namespace
}  // namespace stagelight
