// SPDX-License-Identifier: MIT
#include "scene/mesh_import.h"

#include <cmath>
#include <fstream>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "scene/import.h"
#include "scene/temporary_folder.h"

namespace stagelight {
namespace {

namespace fs = std::filesystem;

testing::AssertionResult is_near(const glm::dvec3 &actual, const glm::dvec3 &expected) {
    if (glm::length(actual - expected) < 1e-6) {
        return testing::AssertionSuccess();
    }
    return testing::AssertionFailure()
           << fmt::format("expected {} {} {}, got {} {} {}", expected.x, expected.y, expected.z,
                          actual.x, actual.y, actual.z);
}

const Vertex &corner(const Scene &scene, std::size_t triangle, std::size_t i) {
    return scene.vertices.at(scene.triangles.at(triangle).vertices.at(i));
}

glm::dvec3 edge(const Scene &scene, std::size_t triangle, std::size_t to) {
    return corner(scene, triangle, to).position - corner(scene, triangle, 0).position;
}

glm::dvec3 facing(const Scene &scene, std::size_t triangle) {
    return glm::normalize(glm::cross(edge(scene, triangle, 1), edge(scene, triangle, 2)));
}

constexpr const char *three_vertices = "v 1 0 0\nv 0 1 0\nv 0 0 1\n";

constexpr const char *cube_without_normals =
    "OFF\n8 6 0\n-1 -1 -1\n-1 -1 1\n-1 1 -1\n-1 1 1\n1 -1 -1\n1 -1 1\n1 1 -1\n1 1 1\n"
    "4 0 1 3 2\n4 4 6 7 5\n4 0 4 5 1\n4 2 3 7 6\n4 0 2 6 4\n4 1 5 7 3\n";

TEST(MeshImport, KeepsPositionsAndNormalsAndTurnsVDown) {
    const TemporaryFolder folder;
    const Scene scene = imported(
        folder.write("a.obj", std::string(three_vertices)
                                  + "vt 0.25 0.75\nvt 0.5 0\nvt 0 1\nvn 0 0 2\nvn 0 3 0\nvn 1 0 0\n"
                                    "f 1/1/1 2/2/2 3/3/3\n"));
    ASSERT_EQ(scene.triangles.size(), 1U);
    EXPECT_TRUE(is_near(corner(scene, 0, 0).position, {1, 0, 0}));
    EXPECT_TRUE(is_near(corner(scene, 0, 1).position, {0, 1, 0}));
    EXPECT_TRUE(is_near(corner(scene, 0, 2).position, {0, 0, 1}));
    EXPECT_TRUE(is_near(corner(scene, 0, 0).normal, {0, 0, 1}));
    EXPECT_TRUE(is_near(corner(scene, 0, 1).normal, {0, 1, 0}));
    EXPECT_TRUE(is_near(corner(scene, 0, 2).normal, {1, 0, 0}));
    EXPECT_EQ(corner(scene, 0, 0).texture_coordinates, glm::dvec2(0.25, 0.25));
    EXPECT_EQ(corner(scene, 0, 1).texture_coordinates, glm::dvec2(0.5, 1));
    EXPECT_EQ(corner(scene, 0, 2).texture_coordinates, glm::dvec2(0, 0));
}

TEST(MeshImport, ScalesThenRotatesAboutXYZThenMoves) {
    const TemporaryFolder folder;
    const fs::path file = folder.write("a.obj", std::string(three_vertices) + "f 1 2 3\n");
    const Scene scene =
        imported(file, {.position = {10, 20, 30}, .rotation = {90, 90, 90}, .scale = {2, 3, 4}});
    // 2x stays on x, goes to -z, stays; 3y goes to z, x, y; 4z goes to -y, stays, goes to x.
    EXPECT_TRUE(is_near(corner(scene, 0, 0).position, {10, 20, 28}));
    EXPECT_TRUE(is_near(corner(scene, 0, 1).position, {10, 23, 30}));
    EXPECT_TRUE(is_near(corner(scene, 0, 2).position, {14, 20, 30}));
}

TEST(MeshImport, PlacesInDoublePrecision) {
    const TemporaryFolder folder;
    const fs::path file = folder.write("a.obj", std::string(three_vertices) + "f 1 2 3\n");
    const Scene scene = imported(file, {.position = {1e6 + 1e-6, 0, 0}});
    EXPECT_NEAR(corner(scene, 0, 1).position.x, 1e6 + 1e-6, 1e-9);
}

TEST(MeshImport, KeepsNormalsAtRightAnglesUnderUnevenScale) {
    const TemporaryFolder folder;
    const fs::path file =
        folder.write("a.obj", "v 1 0 0\nv 0 1 0\nv 0 1 1\nvn 1 1 0\nf 1//1 2//1 3//1\n");
    const Scene scene = imported(file, {.scale = {2, 1, 1}});
    EXPECT_TRUE(is_near(corner(scene, 0, 0).normal, glm::normalize(glm::dvec3(1, 2, 0))));
    EXPECT_NEAR(glm::dot(corner(scene, 0, 0).normal, edge(scene, 0, 1)), 0, 1e-6);
}

TEST(MeshImport, KeepsNormalsOutwardWhenMirrored) {
    const Scene scene = imported(STAGELIGHT_SOURCE_DIR "/scenes/cube.obj", {.scale = {-1, 1, 1}});
    ASSERT_EQ(scene.triangles.size(), 12U);
    for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
        const Vertex &vertex = corner(scene, i, 0);
        EXPECT_GT(glm::dot(vertex.normal, vertex.position), 0) << "normal of triangle " << i;
        EXPECT_TRUE(is_near(facing(scene, i), vertex.normal)) << "winding of triangle " << i;
    }
}

// A triangle in the corner of z = 0, without normals, once in a mirrored node, once in a turned
// one, both moved by their parent; a second mesh that no node places.
constexpr const char *nested_nodes = R"({"asset": {"version": "2.0"}, "scene": 0,
"scenes": [{"nodes": [0]}],
"nodes": [{"translation": [1, 2, 3], "children": [1, 2]},
          {"scale": [-2, 1, 1], "mesh": 0},
          {"rotation": [0, 0, 0.70710678, 0.70710678], "mesh": 0}],
"meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]},
           {"primitives": [{"attributes": {"POSITION": 0}}]}],
"buffers": [{"uri": "a.bin", "byteLength": 36}], "bufferViews": [{"buffer": 0, "byteLength": 36}],
"accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
               "min": [0, 0, 0], "max": [1, 1, 0]}]})";

TEST(MeshImport, AppliesTheTransformsOfNestedNodes) {
    const TemporaryFolder folder;
    constexpr std::array<float, 9> positions{0, 0, 0, 1, 0, 0, 0, 1, 0};
    folder.write("a.bin", {reinterpret_cast<const char *>(positions.data()), sizeof positions});
    const Scene scene = imported(folder.write("a.gltf", nested_nodes));
    ASSERT_EQ(scene.triangles.size(), 2U) << "one for each node that places the first mesh";

    EXPECT_TRUE(is_near(corner(scene, 0, 0).position, {1, 2, 3}));
    EXPECT_TRUE(is_near(edge(scene, 0, 1), {0, 1, 0})) << "swapped, since the node mirrors";
    EXPECT_TRUE(is_near(edge(scene, 0, 2), {-2, 0, 0}));
    EXPECT_TRUE(is_near(corner(scene, 0, 0).normal, {0, 0, 1}));

    EXPECT_TRUE(is_near(corner(scene, 1, 0).position, {1, 2, 3}));
    EXPECT_TRUE(is_near(edge(scene, 1, 1), {0, 1, 0}));
    EXPECT_TRUE(is_near(edge(scene, 1, 2), {-1, 0, 0}));
    EXPECT_TRUE(is_near(corner(scene, 1, 0).normal, {0, 0, 1}));
}

TEST(MeshImport, MadeNormalsLeaveSharpEdgesSharp) {
    const TemporaryFolder folder;
    const Scene scene = imported(folder.write("cube.off", cube_without_normals));
    ASSERT_EQ(scene.triangles.size(), 12U);
    EXPECT_EQ(scene.vertices.size(), 24U) << "four a face: shared within it, not around the edge";
    for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
        EXPECT_TRUE(is_near(corner(scene, i, 0).normal, facing(scene, i))) << "triangle " << i;
    }
}

TEST(MeshImport, MadeNormalsAreSmoothAroundAColumn) {
    std::string vertices;
    std::string faces;
    for (int i = 0; i < 8; ++i) {
        const double angle = i * std::acos(-1.0) / 4;
        const std::string x_z =
            std::to_string(std::cos(angle)) + " {} " + std::to_string(-std::sin(angle)) + "\n";
        for (const char *y : {"0", "1"}) {
            vertices += std::string(x_z).replace(x_z.find("{}"), 2, y);
        }
        const int next = (i + 1) % 8;
        faces += "4 " + std::to_string(2 * i) + " " + std::to_string(2 * next) + " "
                 + std::to_string(2 * next + 1) + " " + std::to_string(2 * i + 1) + "\n";
    }
    const TemporaryFolder folder;
    const Scene scene = imported(folder.write("column.off", "OFF\n16 8 0\n" + vertices + faces));
    ASSERT_EQ(scene.vertices.size(), 16U) << "each shared by the faces around it";
    for (const Vertex &vertex : scene.vertices) {
        EXPECT_TRUE(is_near(vertex.normal, {vertex.position.x, 0, vertex.position.z}));
    }
}

TEST(MeshImport, ReplacesNormalsThatAreNone) {
    const TemporaryFolder folder;
    const Scene scene =
        imported(folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 0\nf 1//1 2//1 3//1\n"),
                 {.scale = {1, 1, -1}});
    EXPECT_TRUE(is_near(corner(scene, 0, 0).normal, {0, 0, -1})) << "the face's own, mirrored";
}

TEST(MeshImport, LeavesOutTrianglesWithoutAreaAndTheirVertices) {
    const TemporaryFolder folder;
    // The second repeats a corner, the third lies on a line, and not exactly once it is placed.
    const Scene scene = imported(
        folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 2\nv 2 3 5\nv 5 9 14\nvn 0 0 1\n"
                              "f 1//1 2//1 3//1\nf 5//1 5//1 1//1\nf 4//1 5//1 6//1\n"),
        {.position = {0.1, 0.2, 0.3}, .rotation = {20, 30, 40}, .scale = {7, 7, 7}});
    EXPECT_EQ(scene.triangles.size(), 1U);
    EXPECT_EQ(scene.vertices.size(), 3U);
}

TEST(MeshImport, KeepsVerticesApartAtASeamOfTheTexture) {
    const TemporaryFolder folder;
    const Scene scene = imported(
        folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 1\nvn 0 0 1\n"
                              "f 1/1/1 2/1/1 3/1/1\nf 1/2/1 3/1/1 4/1/1\n"));
    EXPECT_EQ(scene.vertices.size(), 5U) << "one shared, one at the seam";
    EXPECT_EQ(corner(scene, 1, 0).texture_coordinates, glm::dvec2(1, 0));
}

TEST(MeshImport, TriangulatesPolygonsAndLeavesOutPointsAndLines) {
    const TemporaryFolder folder;
    const Scene scene = imported(
        folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nl 1 3\np 2\n"));
    EXPECT_EQ(scene.triangles.size(), 2U);
    EXPECT_EQ(scene.vertices.size(), 4U);
}

TEST(MeshImport, KeepsTinyMeshesWhole) {
    const TemporaryFolder folder;
    const Scene scene = imported(
        folder.write("a.obj", "v 0 0 0\nv 1e-7 0 0\nv 1e-7 1e-7 0\nv 0 1e-7 0\nf 1 2 3 4\n"),
        {.scale = glm::dvec3(0.001)});
    EXPECT_EQ(scene.triangles.size(), 2U);
    EXPECT_NEAR(corner(scene, 0, 1).position.x, 1e-10, 1e-16);
}

TEST(MeshImport, AppendsToWhatTheSceneHas) {
    const TemporaryFolder folder;
    const fs::path file = folder.write("a.obj", std::string(three_vertices) + "f 1 2 3\n");
    Scene scene = imported(file);
    import_mesh(scene, file, {.position = {5, 0, 0}}, 0, mesh_entry);
    ASSERT_EQ(scene.triangles.size(), 2U);
    ASSERT_EQ(scene.meshes.size(), 2U);
    EXPECT_EQ(scene.meshes[1].file, file);
    EXPECT_EQ(scene.meshes[1].where.line, mesh_entry.line);
    EXPECT_EQ(scene.triangles[0].mesh, 0);
    EXPECT_EQ(scene.triangles[1].mesh, 1);
    EXPECT_TRUE(is_near(corner(scene, 0, 0).position, {1, 0, 0}));
    EXPECT_TRUE(is_near(corner(scene, 1, 0).position, {6, 0, 0}));
}

TEST(MeshImport, Stage06CubeShowsItsPictureUprightFromOutside) {
    const Scene scene = imported(STAGELIGHT_SOURCE_DIR "/scenes/cube.obj");
    ASSERT_EQ(scene.triangles.size(), 12U);
    EXPECT_EQ(scene.vertices.size(), 24U);
    for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
        const glm::dvec2 origin = corner(scene, i, 0).texture_coordinates;
        const glm::dvec2 b = corner(scene, i, 1).texture_coordinates - origin;
        const glm::dvec2 c = corner(scene, i, 2).texture_coordinates - origin;
        const double area = b.x * c.y - b.y * c.x;
        const glm::dvec3 right = (c.y * edge(scene, i, 1) - b.y * edge(scene, i, 2)) / area;
        const glm::dvec3 down = (b.x * edge(scene, i, 2) - c.x * edge(scene, i, 1)) / area;
        const glm::dvec3 normal = corner(scene, i, 0).normal;
        EXPECT_TRUE(is_near(glm::cross(down, right) / 4.0, normal)) << "triangle " << i;
        EXPECT_TRUE(normal.y != 0 || is_near(down, {0, -2, 0})) << "triangle " << i;
    }
}

}  // namespace
}  // namespace stagelight
