// SPDX-License-Identifier: MIT
#include "scene/contact.h"

#include <algorithm>
#include <functional>
#include <string>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "scene/closed_mesh.h"
#include "scene/contact_scenes.h"

namespace stagelight {
namespace {

using Contact = ContactScenes;

TEST_F(Contact, AGlassCubeSinksIntoTheFloor) {
    const std::string cube_only = mesh("cube.obj");
    const std::string scene = cube_only + plane("0, 1, 0", "0, -1, 0", "paint");
    const auto here = corners_of_mesh(load(cube_only), 0);
    const auto moved = moves(scene, 0, cube_only);
    for (std::size_t i = 0; i < here.size(); ++i) {
        if (here[i].y > 0) {
            expect_still({moved[i]});
        } else {
            expect_moved({moved[i]}, {0, -1, 0});
        }
    }
    EXPECT_TRUE(open_dielectric_meshes(load(scene)).empty());
    expect_agreeing_normals(load(scene));
}

// The vertices of the edge between them are moved both ways, by as much as each surface asks for.
TEST_F(Contact, ACubeInACornerSinksIntoBoth) {
    const std::string cube_only = mesh("cube.obj");
    const auto here = corners_of_mesh(load(cube_only), 0);
    const std::string floor = plane("0, 1, 0", "0, -1, 0", "paint");
    const auto by_floor = moves(cube_only + floor, 0, cube_only);
    const auto moved =
        moves(cube_only + floor + plane("1, 0, 0", "-1, 0, 0", "paint"), 0, cube_only);
    for (std::size_t i = 0; i < here.size(); ++i) {
        EXPECT_EQ(moved[i].x < -least, here[i].x < 0);
        EXPECT_EQ(moved[i].y < -least, here[i].y < 0);
        EXPECT_GT(std::min(moved[i].x, moved[i].y), -most);
        if (here[i].x < 0 && here[i].y < 0) {
            EXPECT_NEAR(moved[i].x, moved[i].y, 1e-15);
            EXPECT_LT(moved[i].y, by_floor[i].y + 1e-15);
        }
    }
}

TEST_F(Contact, AnOpaqueSolidOnAnOpaqueSurfaceStays) {
    const std::string cube_only = mesh("cube.obj", "0, 0, 0", "paint");
    const std::string floor = plane("0, 1, 0", "0, -1, 0", "paint");
    const std::string sheet =
        mesh("front.obj", "0, -1, 0", "paint", "rotation = [-90, 0, 0]\nscale = 3\n");
    expect_still(moves(floor + cube_only, 0, cube_only));
    expect_still(moves(sheet + cube_only, 1, cube_only));
    expect_still(moves(cube_only + sheet, 1, sheet));
    const std::string above = mesh("cube.obj", "0, 2, 0", "paint");
    expect_still(moves(cube_only + above, 1, above));
    // From below, the floor's other side shows, and the cube is moved.
    const std::string high = mesh("cube.obj", "0, 3, 0", "paint");
    const auto moved = moves(high + plane("0, 1, 0", "0, 2, 0", "paint"), 0, high);
    EXPECT_LT(std::ranges::min(moved, {}, &glm::dvec3::y).y, -least);
    const std::string ceiling = plane("0, -1, 0", "0, 1, 0", "paint");
    expect_still(moves(cube_only + ceiling, 0, cube_only));
}

TEST_F(Contact, APictureComesBeforeItsWall) {
    const std::string small = mesh("front.obj", "0, 0, -1", "paint", "scale = 0.5\n");
    const std::string wall = mesh("front.obj", "0, 0, -1", "soft");
    const std::string turned = mesh("back.obj", "0, 0, -1", "paint", "scale = 0.5\n");
    const std::string endless = plane("0, 0, 1", "0, 0, -1", "paint");
    expect_moved(moves(wall + small, 1, small), {0, 0, 1});
    expect_still(moves(wall + small, 0, wall));
    expect_moved(moves(small + wall, 1, wall), {0, 0, 1});
    expect_moved(moves(endless + small, 0, small), {0, 0, 1});
    expect_moved(moves(small + endless, 0, small), {0, 0, 1});
    // They have a corner in common, and are two meshes even so.
    const std::string larger = mesh("front.obj", "1, 1, 0", "paint", "scale = 2\n");
    expect_moved(moves(mesh("front.obj", "0, 0, 0", "paint") + larger, 1, larger), {0, 0, 1});
    // Its own side is that of its normals.
    folder.write("normals.obj", square + "vn 0 0 1\nf 1//1 3//1 2//1\nf 1//1 4//1 3//1\n");
    const std::string by_normals = mesh("normals.obj", "0, 0, -1", "glass", "scale = 0.5\n");
    expect_moved(moves(endless + by_normals, 0, by_normals), {0, 0, 1});
    // It is not pushed to where the wall hides it, but shows on its own side of a sheet.
    expect_moved(moves(turned + endless, 0, turned), {0, 0, 1});
    const std::string box = mesh("cube.obj", "0, 0, -2", "paint");
    expect_moved(moves(box + turned, 1, turned), {0, 0, 1});
    const std::string painted = mesh("front.obj", "0, 0, -1", "paint");
    expect_moved(moves(painted + turned, 1, turned), {0, 0, -1});
}

// Nearer to each other than rounding can tell, on this side or that.
TEST_F(Contact, EachOfAPileComesBeforeTheLast) {
    const std::string bottom = mesh("front.obj", "0, 0, 0", "soft");
    const std::string second = mesh("front.obj", "0.5, 0, 0", "hard");
    const std::string third = mesh("front.obj", "0, 0.5, 0", "glass");
    expect_moved(moves(bottom + second + third, 1, second), {0, 0, 1});
    expect_moved(moves(bottom + second + third, 2, third), {0, 0, 1}, 2);
    const std::string back = mesh("back.obj", "0, 0.5, 0", "glass");
    expect_moved(moves(bottom + second + back, 2, back), {0, 0, -1});
}

TEST_F(Contact, OfTwoGlassCubesTheSecondReachesIntoTheFirst) {
    const std::string first = mesh("cube.obj"), second = mesh("cube.obj", "0, 2, 0", "soft");
    expect_still(moves(first + second, 0, first));
    const auto here = corners_of_mesh(load(second), 0);
    const auto moved = moves(first + second, 1, second);
    for (std::size_t i = 0; i < here.size(); ++i) {
        if (here[i].y > 2) {
            expect_still({moved[i]});
        } else {
            expect_moved({moved[i]}, {0, -1, 0});
        }
    }
}

// In one file, with corners of the tops in common: only the second's are moved.
TEST_F(Contact, PartsOfOneMeshAreMovedByThemselves) {
    folder.write("two.obj", cube(false) + cube(false, {2, 0, 0}, {1, 1, 1}, 8));
    const Scene scene = load(mesh("two.obj"));
    const auto moved = corners_of_mesh(scene, 0);
    EXPECT_TRUE(open_dielectric_meshes(scene).empty());
    for (std::size_t i = 0; i < moved.size(); ++i) {
        const double seam = moved[i].x - 1;
        if (i < 36) {
            EXPECT_TRUE(seam == 0 || seam == -2) << i;
        } else if (seam < 1) {
            expect_moved({{seam, 0, 0}}, {-1, 0, 0});
        }
    }
}

TEST_F(Contact, TheSidesOfASheetAreParted) {
    folder.write("a.mtl", "newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n");
    folder.write("sheet.obj",
                 "mtllib a.mtl\n" + square
                     + "usemtl red\nf 1 2 3\nf 1 3 4\nusemtl blue\nf 1 3 2\nf 1 4 3\n");
    const std::string own = "[[meshes]]\nfile = \"sheet.obj\"\n";
    const auto corners = corners_of_mesh(load(own), 0);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (i < 6) {
            EXPECT_EQ(corners[i].z, 0) << "the earlier one stays";
        } else {
            expect_moved({{0, 0, corners[i].z}}, {0, 0, -1});
        }
    }
    const std::string one = mesh("sheet.obj", "0, 0, 0", "paint");
    for (const glm::dvec3 &corner : corners_of_mesh(load(one), 0)) {
        EXPECT_EQ(corner.z, 0) << "of one material";
    }
    expect_still(moves(mesh("front.obj", "0, 0, 0", "paint") + mesh("back.obj", "0, 0, 0", "paint"),
                       1, mesh("back.obj", "0, 0, 0", "paint")));
}

// On the wall the sheet comes before the wall, and its picture before the sheet.
TEST_F(Contact, APictureOnASheetOnAWall) {
    folder.write("a.mtl", "newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n");
    folder.write("poster.obj", "mtllib a.mtl\n" + square
                                   + "v 0 -1 0\nv -1 0 0\nusemtl red\nf 1 2 3\nf 1 3 4\n"
                                     "usemtl blue\nf 1 5 6\n");
    const auto corners = corners_of_mesh(
        load("[[meshes]]\nfile = \"poster.obj\"\n" + plane("0, 0, 1", "0, 0, 0", "paint")), 0);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        EXPECT_NEAR(corners[i].z / corners[0].z, i < 6 ? 1 : 2, 0.1);
    }
}

TEST_F(Contact, PlanesAndSpheres) {
    const Scene planes =
        load(plane("0, 1, 0", "3, -2, 0") + plane("0, 2, 0", "0, -2, 7", "paint")
             + plane("0, -1, 0", "0, -2, 0", "paint") + plane("0, 1, 0", "0, -2.001, 0", "soft")
             + plane("0, 1, 1e-3", "0, -2, 0", "soft"));
    EXPECT_EQ(planes.planes[0].point, glm::dvec3(3, -2, 0));
    EXPECT_GT(planes.planes[1].point.y, -2 + 64 * 0x1p-24);
    EXPECT_LT(planes.planes[1].point.y, -2 + most);
    EXPECT_LT(planes.planes[2].point.y, -2 - 64 * 0x1p-24) << "on the glass from below";
    EXPECT_GT(planes.planes[2].point.y, -2 - most);
    EXPECT_EQ(planes.planes[3].point.y, -2.001);
    EXPECT_EQ(planes.planes[4].point.y, -2);
    const std::string same = plane("0, 1, 0", "0, -3, 0", "paint");
    EXPECT_EQ(load(same + same).planes[1].point.y, -3);
    const Scene pile = load(plane("0, 1, 0", "0, -2, 0") + plane("0, 1, 0", "0, -2, 0", "soft")
                            + plane("0, 1, 0", "0, -2, 0", "hard"));
    EXPECT_NEAR((pile.planes[2].point.y + 2) / (pile.planes[1].point.y + 2), 2, 1e-6);
    const Scene spheres =
        load(sphere("0, 0, 0", 1) + sphere("0, 0, 0", 1, "paint") + sphere("2, 0, 0", 1)
             + sphere("0, 0, 0", 0.999) + sphere("0, 0, 0", 1, "paint"));
    EXPECT_EQ(spheres.spheres[0].radius, 1);
    EXPECT_GT(spheres.spheres[1].radius, 1 + least);
    EXPECT_LT(spheres.spheres[1].radius, 1 + most);
    EXPECT_EQ(spheres.spheres[2].radius, 1);
    EXPECT_EQ(spheres.spheres[3].radius, 0.999);
    EXPECT_GT(spheres.spheres[4].radius, 1 + least) << "it looks like the second, not the first";
}

// The rounding of the coordinates counts too, not only that of the distance.

}  // namespace
}  // namespace stagelight
