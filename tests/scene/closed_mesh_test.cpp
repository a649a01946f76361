// SPDX-License-Identifier: MIT
#include "scene/closed_mesh.h"

#include <gtest/gtest.h>

#include "scene/scene_file.h"
#include "scene/temporary_folder.h"

namespace stagelight {
namespace {

constexpr auto head = "[camera]\nposition = [0, 0, 5]\nlook_at = [0, 0, 0]\n"
                      "[materials.glass]\ntype = \"dielectric\"\n";

// A pyramid on three corners; `faces` has more or fewer.
std::string pyramid(const std::string &faces) {
    return "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n" + faces;
}

const std::string all_faces = "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";

class ClosedMesh : public testing::Test {
protected:
    std::vector<std::string> told(const std::string &obj, const std::string &placing = "",
                                  const std::string &material = "glass") const {
        folder.write("a.obj", obj);
        const auto file =
            folder.write("scene.toml", head + std::string("[materials.paint]\ntype = \"diffuse\"\n")
                                           + "[[meshes]]\nfile = \"a.obj\"\nmaterial = \""
                                           + material + "\"\n" + placing);
        return open_dielectric_meshes(load_scene(file));
    }
    void expect_open(const std::string &obj, int edges) const {
        const auto lines = told(obj);
        ASSERT_EQ(lines.size(), 1u);
        EXPECT_NE(lines[0].find("scene.toml:9:8: "), std::string::npos) << lines[0];
        EXPECT_NE(lines[0].find("a.obj is a dielectric but not closed: " + std::to_string(edges)
                                + " of its edges"),
                  std::string::npos)
            << lines[0];
    }
    TemporaryFolder folder;
};

TEST_F(ClosedMesh, IsOneWhoseEdgesHaveTwoTriangles) {
    EXPECT_EQ(told(pyramid(all_faces)), std::vector<std::string>{});
}

TEST_F(ClosedMesh, HasNoHole) {
    expect_open(pyramid("f 1 3 2\nf 1 2 4\nf 2 3 4\n"), 3);
}

// A wall inside: where is in, and where is out?
TEST_F(ClosedMesh, HasNoThirdTriangleAtAnEdge) {
    expect_open(pyramid("v 0.2 0.2 0.2\n" + all_faces + "f 1 2 5\n"), 3);
}

// Corners of their own at each face, with other normals and texture coordinates, and a zero of
// either sign; turned and moved, so that no coordinate is round.
TEST_F(ClosedMesh, IsWeldedByPositionAlone) {
    const std::string cube = "v 0 0 0\nv 1 -0 0\nv 0 1 0\nv -0 -0 1\n"
                             "v 0 0 -0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nvt 1 0\nvt 0 1\n"
                             "vn 1 0 0\nvn 0 1 0\nvn 0 0 1\n"
                             "f 1/1/1 3/2/1 2/3/1\nf 5/3/2 6/2/2 8/1/2\n"
                             "f 2/1/3 7/2/3 4/3/3\nf 3/3/1 5/2/1 4/1/1\n";
    EXPECT_EQ(told(cube, "position = [0.1, 20.3, -7.7]\nrotation = [33, 12, 71]\nscale = 0.3\n"),
              std::vector<std::string>{});
}

TEST_F(ClosedMesh, IsOfNoInterestToPaint) {
    EXPECT_EQ(told(pyramid("f 1 3 2\n"), "", "paint"), std::vector<std::string>{});
}

// Each [[meshes]] is closed for itself: two halves that touch are two that are open.
TEST_F(ClosedMesh, IsNotClosedByAnother) {
    folder.write("b.obj", pyramid("f 3 1 4\n"));
    const auto lines = told(pyramid("f 1 3 2\nf 1 2 4\nf 2 3 4\n"),
                            "[[meshes]]\nfile = \"b.obj\"\nmaterial = \"glass\"\n");
    ASSERT_EQ(lines.size(), 2u);
    EXPECT_NE(lines[1].find("scene.toml:12:8: "), std::string::npos) << lines[1];
    EXPECT_NE(lines[1].find("b.obj is"), std::string::npos) << lines[1];
}

}  // namespace
}  // namespace stagelight
