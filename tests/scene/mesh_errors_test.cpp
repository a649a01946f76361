// SPDX-License-Identifier: MIT
#include <numeric>
#include <ostream>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include "scene/import.h"
#include "scene/messages.h"
#include "scene/temporary_folder.h"

namespace stagelight {
namespace {

namespace fs = std::filesystem;

// The message that `file` is refused with; it prints nothing.
std::string refusal(const fs::path &file) {
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const std::string message = message_of([&] { imported(file); });
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "") << "Assimp is to be quiet";
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << "Assimp is to be quiet";
    return message;
}

// One line that says where, which file, what is wrong and what was expected.
void expect_refusal(const fs::path &file, const std::string &reason) {
    const std::string message = refusal(file);
    EXPECT_EQ(message.rfind("scene.toml:3:1: " + file.string() + ": ", 0), 0U) << message;
    EXPECT_NE(message.find(reason), std::string::npos)
        << "expected '" << reason << "' in: " << message;
    EXPECT_NE(message.find("expected"), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

struct BadFile {
    const char *name;
    const char *reason;
};

void PrintTo(const BadFile &file, std::ostream *out) {
    *out << file.name;
}

class AssimpTestModel : public testing::TestWithParam<BadFile> {};

TEST_P(AssimpTestModel, IsRefused) {
    const fs::path file = fs::path("/usr/share/assimp/models") / GetParam().name;
    ASSERT_TRUE(fs::exists(file)) << file << " is in Debian's assimp-testmodels";
    expect_refusal(file, GetParam().reason);
}

INSTANTIATE_TEST_SUITE_P(
    MeshErrors, AssimpTestModel,
    testing::Values(
        BadFile{"OFF/invalid.off", "no triangles"},
        BadFile{"glTF2/IndexOutOfRange/IndexOutOfRange.gltf", "index out of range"},
        BadFile{"glTF2/IndexOutOfRange/AllIndicesOutOfRange.gltf", "index out of range"},
        BadFile{"glTF2/BoxWithInfinites-glTF-Binary/BoxWithInfinites.glb", "not finite"},
        BadFile{"glTF2/RecursiveNodes/RecursiveNodes.gltf", "recursive reference to itself"},
        BadFile{"glTF2/MissingBin/BoxTextured.gltf", "BoxTextured0.bin"},
        BadFile{"glTF2/TestNoRootNode/NoScene.gltf", "No scene"},
        BadFile{"glTF2/TestNoRootNode/SceneWithoutNodes.gltf", "no triangles"},
        BadFile{"OBJ/point_cloud.obj", "no triangles"},
        BadFile{"Collada/cameras.dae", "no triangles"}, BadFile{"invalid/empty.obj", "too small"},
        BadFile{"invalid/malformed.obj", "Invalid face index"}));

TEST(MeshErrors, MissingFile) {
    const TemporaryFolder folder;
    expect_refusal(folder.path() / "none.obj", "no such file");
}

TEST(MeshErrors, Folder) {
    const TemporaryFolder folder;
    expect_refusal(folder.path(), "no such file");
}

TEST(MeshErrors, EmptyFile) {
    const TemporaryFolder folder;
    expect_refusal(folder.write("empty.ply", ""), "can't be read");
}

TEST(MeshErrors, TextFile) {
    const TemporaryFolder folder;
    expect_refusal(folder.write("a.txt", "no mesh at all\n"), "can't be read");
}

// Assimp's reader of PLY would be busy to its limit of time.
TEST(MeshErrors, PlyThatPromisesMoreThanItHolds) {
    const TemporaryFolder folder;
    expect_refusal(folder.write("a.ply", "ply\nformat binary_big_endian 1.0\nelement vertex 4\n"
                                         "property float x\nelement face 2 more\n"),
                   "its header has no end");
}

TEST(MeshErrors, IndexOutOfRangeInAFileThatAssimpTakes) {
    const TemporaryFolder folder;
    expect_refusal(folder.write("a.ply", "ply\nformat ascii 1.0\nelement vertex 3\n"
                                         "property float x\nproperty float y\nproperty float z\n"
                                         "element face 1\n"
                                         "property list uchar int vertex_indices\nend_header\n"
                                         "0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n"),
                   "index out of range");
}

TEST(MeshErrors, CoordinatesThatAreNoNumbers) {
    const TemporaryFolder folder;
    for (const std::string number : {"nan", "-nan", "inf", "-inf"}) {
        expect_refusal(folder.write("a.obj", "v 0 0 0\nv " + number + " 0 0\nv 0 1 0\nf 1 2 3\n"),
                       "not finite");
        expect_refusal(folder.write("a.ply", "ply\nformat ascii 1.0\nelement vertex 3\n"
                                             "property float x\nproperty float y\n"
                                             "property float z\nelement face 1\n"
                                             "property list uchar int vertex_indices\nend_header\n"
                                             "0 0 0\n1 0 0\n0 1 "
                                                 + number + "\n3 0 1 2\n"),
                       "not finite");
    }
}

// {{ and }} are fmt's braces.
constexpr const char *often_placed = R"({{"asset": {{"version": "2.0"}}, "scene": 0,
"scenes": [{{"nodes": [{0}]}}], "nodes": [{1}],
"meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0}}}}]}}],
"buffers": [{{"uri": "a.bin", "byteLength": {2}}}], "bufferViews": [{{"buffer": 0, "byteLength": {2}}}],
"accessors": [{{"bufferView": 0, "componentType": 5126, "count": {3}, "type": "VEC3"}}]}})";

// A file of a few megabytes can place its mesh any number of times.
TEST(MeshErrors, MoreTrianglesThanMemoryHolds) {
    constexpr int triangles = 100000;
    constexpr std::size_t nodes = 21475;  // which makes 2^31
    const TemporaryFolder folder;
    folder.write("a.bin", std::string(triangles * 36, '\0'));
    std::vector<std::size_t> names(nodes);
    std::iota(names.begin(), names.end(), 0);
    const std::vector<std::string> placed(nodes, R"({"mesh": 0})");
    expect_refusal(
        folder.write("a.gltf", fmt::format(often_placed, fmt::join(names, ","),
                                           fmt::join(placed, ","), triangles * 36, triangles * 3)),
        "makes 2147500000 triangles of the scene, expected at most ");
}

TEST(MeshErrors, OnlyTrianglesWithoutArea) {
    const TemporaryFolder folder;
    expect_refusal(folder.write("a.obj", "v 0 0 0\nv 1 1 1\nv 2 2 2\nf 1 2 3\n"), "no triangles");
}

// The triangles of the mesh before it are none of its own.
TEST(MeshErrors, ASecondMeshWithoutTriangles) {
    const TemporaryFolder folder;
    Scene scene =
        imported(folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 1\nf 1 2 3\nf 2 3 4\n"));
    const fs::path flat = folder.write("flat.obj", "v 0 0 0\nv 1 1 1\nv 2 2 2\nf 1 2 3\n");
    EXPECT_NE(message_of([&] {
                  import_mesh(scene, flat, {}, material_of_file, mesh_entry);
              }).find("has no triangles"),
              std::string::npos);
}

TEST(MeshErrors, PlacedWithoutArea) {
    const TemporaryFolder folder;
    Scene scene;
    EXPECT_EQ(message_of([&] {
                  import_mesh(scene, folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
                              {.scale = {1, 1e-14, 1}}, material_of_file, mesh_entry);
              }),
              "scene.toml:3:1: " + (folder.path() / "a.obj").string()
                  + ": is placed without an area, expected a larger scale");
}

TEST(MeshErrors, OutOfReach) {
    const TemporaryFolder folder;
    expect_refusal(folder.write("a.obj", "v 0 0 0\nv 1e30 0 0\nv 0 1e30 0\nf 1 2 3\n"),
                   "out of reach");
}

}  // namespace
}  // namespace stagelight
