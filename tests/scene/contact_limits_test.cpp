// SPDX-License-Identifier: MIT
#include "scene/contact.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "scene/contact_scenes.h"

namespace stagelight {
namespace {

using ContactLimits = ContactScenes;

TEST_F(ContactLimits, AllComesAsFarBefore) {
    for (const char *material : {"paint", "glass"}) {
        for (const char *file : {"front.obj", "back.obj"}) {
            const auto height = [&](const char *position) {
                return corners_of_mesh(load(plane("0, 0, 1", "0, 0, 0", "paint")
                                            + mesh(file, position, material)),
                                       0)[0]
                    .z;
            };
            const double flush = height("0, 0, 0");
            EXPECT_GT(std::abs(flush), least);
            EXPECT_NEAR(height("0, 0, 6e-7"), flush, 1e-11);
            EXPECT_NEAR(height("0, 0, -6e-7"), flush, 1e-11);
        }
    }
}

TEST_F(ContactLimits, OnlyWhatTouchesIsMoved) {
    const std::string floor = plane("0, 1, 0", "0, -1, 0");
    folder.write("ball.obj", ball());
    const std::string on_a_point = mesh("ball.obj");
    expect_still(moves(floor + on_a_point, 0, on_a_point));
    for (const char *place : {"0, 1e-5, 0", "0, -1e-5, 0"}) {
        const std::string near = mesh("cube.obj", place);
        expect_still(moves(floor + near, 0, near));
    }
    // A speck that stands upright.
    const std::string speck =
        mesh("front.obj", "0, -1, 0", "paint", "rotation = [0, 90, 0]\nscale = 1e-8\n");
    expect_still(moves(floor + speck, 0, speck));
    // Tops in one plane, side by side, and one corner of each at the other.
    const std::string first = mesh("cube.obj", "0, 0, 0", "paint");
    for (const char *place : {"2, 0, 0", "2, 0, 2"}) {
        const std::string beside = mesh("cube.obj", place, "paint");
        expect_still(moves(first + beside, 1, beside));
    }
    // Edges that cross in one plane, triangles that don't.
    folder.write("corner.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const std::string corner = mesh("corner.obj", "0, 0, 0", "paint");
    const std::string other =
        mesh("corner.obj", "1.01, 1.01, 0", "soft", "rotation = [0, 0, 180]\n");
    expect_still(moves(corner + other, 1, other));
    const std::string closer =
        mesh("corner.obj", "0.99, 0.99, 0", "soft", "rotation = [0, 0, 180]\n");
    expect_moved(moves(corner + closer, 1, closer), {0, 0, 1});
}

TEST_F(ContactLimits, IsAFiftiethOfAPixelAtMost) {
    const std::string floor = plane("0, 1, 0", "0, -1, 0", "paint");
    const std::string cube_only = mesh("cube.obj");
    for (const double fov : {0.1, 1.0, 60.0}) {
        Scene scene = load(cube_only);
        scene.planes = load(floor).planes;
        scene.camera.fov = fov;
        settle_contacts(scene);
        const double pixel = 2 * std::tan(fov * 3.14159265 / 360) / 640;
        for (const glm::dvec3 &corner : corners_of_mesh(scene, 0)) {
            if (corner.y < 0) {
                EXPECT_LT(corner.y, -1);
                EXPECT_GT(corner.y, -1 - pixel / 50 * 7);
            }
        }
    }
    // Nothing is pulled nearer.
    Scene narrow = load(mesh("front.obj", "0, 0, 6e-7", "paint"));
    narrow.planes = load(plane("0, 0, 1", "0, 0, 0", "paint")).planes;
    narrow.camera.fov = 0.1;
    settle_contacts(narrow);
    EXPECT_EQ(narrow.vertices[0].position.z, 6e-7);
    // However far a floor goes, it is raised by what it is near. (A larger one would be cut.)
    folder.write("ground.obj", "v -25 0 -25\nv 25 0 -25\nv 25 0 25\nv -25 0 25\n"
                               "f 4 3 2\nf 4 2 1\n");
    const std::string ground = mesh("ground.obj", "0, -1, 0", "paint");
    expect_moved(moves(cube_only + ground, 1, ground), {0, 1, 0});
}

TEST_F(ContactLimits, FarFromTheOrigin) {
    Scene scene = load(mesh("cube.obj", "0, 1000.0001, 0"));
    scene.planes = load(plane("0, 1, 0", "0, 999, 0", "paint")).planes;
    scene.camera.position = {0, 1000, 5};
    settle_contacts(scene);
    double lowest = 1000;
    for (const glm::dvec3 &corner : corners_of_mesh(scene, 0)) {
        lowest = std::min(lowest, corner.y);
    }
    EXPECT_LT(lowest, 999 - 1e-4);
    EXPECT_GT(lowest, 999 - 1e-3);
    // A slope through the origin, and 1e-4 above it a sheet far down the slope.
    const glm::dvec3 normal(0, 0.6, 0.8);
    scene = load(mesh("front.obj", "0, 800.00006, -599.99992", "paint",
                      "rotation = [-36.869897645844, 0, 0]\n"));
    scene.planes = load(plane("0, 0.6, 0.8", "0, 0, 0", "paint")).planes;
    scene.camera.position = {0, 800, -595};
    settle_contacts(scene);
    EXPECT_GT(glm::dot(scene.vertices[0].position, normal), 1.2e-4);
}

}  // namespace
}  // namespace stagelight
