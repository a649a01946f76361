// SPDX-License-Identifier: MIT
#include "scene/outward_normals.h"

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "scene/glass_meshes.h"

namespace stagelight {
namespace {

class OutwardNormals : public GlassMesh {};

TEST_F(OutwardNormals, KeepsNormalsThatAreRight) {
    const Scene right = load(cube_with_normals(false, 1));
    for (const Scene &scene : {load(cube_with_normals(true, 1)), load(cube_with_normals(false, -1)),
                               load(cube_with_normals(true, -1))}) {
        EXPECT_NEAR(volume_of(scene), 8, 1e-12);
        expect_agreeing_normals(scene);
        EXPECT_EQ(scene.vertices.size(), right.vertices.size());
    }
}

TEST_F(OutwardNormals, TurnsLeaningNormalsWithTheRest) {
    const Scene right = load(leaning(1));
    for (const Scene &scene :
         {load(leaning(-1)), load(reversed(leaning(-1))), load(reversed(leaning(1)))}) {
        ASSERT_EQ(scene.vertices.size(), right.vertices.size());
        for (const Vertex &vertex : right.vertices) {
            EXPECT_TRUE(std::ranges::any_of(scene.vertices, [&](const Vertex &other) {
                return other.position == vertex.position && other.normal == vertex.normal;
            }));
        }
    }
}

TEST_F(OutwardNormals, TurnsTheNormalsOfASingleFace) {
    std::string obj = cube_with_normals(false, 1);
    obj.replace(obj.find("vn 0 1 0"), 8, "vn 0 -1 0");
    expect_same(load(obj), load(cube_with_normals(false, 1)));
}

TEST_F(OutwardNormals, SmoothsWhatItHasTurned) {
    const Scene right = load(ball()), turned = load(ball(150));
    ASSERT_EQ(turned.triangles.size(), right.triangles.size());
    EXPECT_NEAR(volume_of(turned), volume_of(right), 1e-12);
    for (std::size_t i = 0; i < right.triangles.size(); ++i) {
        for (const std::uint32_t vertex : turned.triangles[i].vertices) {
            const Vertex &one = turned.vertices[vertex];
            const bool is_there =
                std::ranges::any_of(right.triangles[i].vertices, [&](std::uint32_t other) {
                    return right.vertices[other].position == one.position
                           && glm::distance(right.vertices[other].normal, one.normal) < 1e-5;
                });
            ASSERT_TRUE(is_there) << "corner of triangle " << i;
        }
    }
}

TEST_F(OutwardNormals, SmoothsNoOthers) {
    std::string obj = ball(150);
    std::string normals = obj.substr(0, obj.find("f "));
    std::string faces;
    for (std::size_t at = 0; (at = normals.find("v ", at)) != std::string::npos; at += 3) {
        normals.insert(at + 1, "n");
    }
    std::istringstream lines(obj.substr(obj.find("f ")));
    int count = 0;
    for (std::string f, a, b, c; lines >> f >> a >> b >> c; ++count) {
        faces += count == 150 ? fmt::format("f {0}//{3} {1}//{3} {2}//{3}\n", a, b, c, 12 * 24 + 25)
                              : fmt::format("f {0}//{0} {1}//{1} {2}//{2}\n", a, b, c);
    }
    const Scene plain = load(ball());
    const auto [a, b, c] = corners_of(plain, plain.triangles[150]);
    const glm::dvec3 inwards = -glm::normalize(glm::cross(b - a, c - a));
    obj = obj.substr(0, obj.find("f ")) + normals
          + fmt::format("vn {} {} {}\n", inwards.x, inwards.y, inwards.z) + faces;
    const Scene scene = load(obj);
    expect_agreeing_normals(scene);
    for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
        for (const std::uint32_t vertex : scene.triangles[i].vertices) {
            ASSERT_LT(glm::distance(scene.vertices[vertex].normal,
                                    i == 150 ? -inwards
                                             : glm::normalize(scene.vertices[vertex].position)),
                      1e-6)
                << "triangle " << i;
        }
    }
}

}  // namespace
}  // namespace stagelight
