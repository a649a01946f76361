// SPDX-License-Identifier: MIT
// What glTF says and Assimp's reader leaves out or gets wrong.
#include <cmath>
#include <cstdint>
#include <filesystem>

#include <gtest/gtest.h>

#include "scene/gltf_writer.h"
#include "scene/import.h"
#include "scene/messages.h"
#include "scene/near.h"

namespace stagelight {
namespace {

using nlohmann::json;

class GltfInput : public testing::Test {
protected:
    Scene load() { return imported(gltf.write(folder)); }

    std::string refusal() {
        return message_of([&] { load(); });
    }

    static const Vertex &corner(const Scene &scene, std::size_t triangle, std::size_t i) {
        return scene.vertices.at(scene.triangles.at(triangle).vertices.at(i));
    }

    // Three corners of a picture: all formats say the same.
    static void expect_corners(const Scene &scene) {
        EXPECT_TRUE(is_near(corner(scene, 0, 0).texture_coordinates, glm::dvec2(0, 0)));
        EXPECT_TRUE(is_near(corner(scene, 0, 1).texture_coordinates, glm::dvec2(1, 0)));
        EXPECT_TRUE(is_near(corner(scene, 0, 2).texture_coordinates, glm::dvec2(0, 1)));
    }

    static void expect_colors(const Scene &scene) {
        EXPECT_TRUE(is_near(corner(scene, 0, 0).color, glm::dvec3(1, 0, 0)));
        EXPECT_TRUE(is_near(corner(scene, 0, 1).color, glm::dvec3(0, 1, 0)));
        EXPECT_TRUE(is_near(corner(scene, 0, 2).color, glm::dvec3(0.2, 0.4, 0.6)));
    }

    // A material whose picture is moved like this.
    void move_texture(const json &transform) {
        gltf.attribute("TEXCOORD_0", std::vector<float>{0, 0, 1, 0, 0, 1}, "VEC2");
        std::filesystem::copy_file(STAGELIGHT_SOURCE_DIR "/scenes/checker.png",
                                   folder.path() / "c.png",
                                   std::filesystem::copy_options::overwrite_existing);
        gltf.document["images"] = {{{"uri", "c.png"}}};
        gltf.document["textures"] = {{{"source", 0}}};
        gltf.document["materials"] = {
            {{"pbrMetallicRoughness",
              {{"baseColorTexture",
                {{"index", 0}, {"extensions", {{"KHR_texture_transform", transform}}}}}}}}};
        gltf.document["extensionsUsed"] = {"KHR_texture_transform"};
        gltf.primitive()["material"] = 0;
    }

    TemporaryFolder folder;
    GltfWriter gltf;
};

TEST_F(GltfInput, DividesNormalisedTextureCoordinates) {
    gltf.attribute("TEXCOORD_0", std::vector<std::uint8_t>{0, 0, 0, 0, 255, 0, 0, 0, 0, 255, 0, 0},
                   "VEC2", true);
    // Rows of two bytes are padded to four, as the specification demands.
    gltf.document["bufferViews"].back()["byteStride"] = 4;
    gltf.document["accessors"].back()["count"] = 3;
    expect_corners(load());
    gltf.attribute("TEXCOORD_0", std::vector<std::uint16_t>{0, 0, 65535, 0, 0, 65535}, "VEC2",
                   true);
    expect_corners(load());
}

TEST_F(GltfInput, TakesQuantisedPositionsAndNormals) {
    gltf.document["extensionsRequired"] = {"KHR_mesh_quantization"};
    gltf.document["extensionsUsed"] = {"KHR_mesh_quantization"};
    gltf.attribute("POSITION",
                   std::vector<std::int16_t>{0, 0, 0, 0, 32767, 0, 0, 0, 0, -32767, 0, 0}, "VEC3",
                   true);
    gltf.document["bufferViews"].back()["byteStride"] = 8;
    gltf.attribute("NORMAL", std::vector<std::int8_t>{0, 0, -127, 0, 0, 0, -127, 0, 0, 0, -127, 0},
                   "VEC3", true);
    gltf.document["bufferViews"].back()["byteStride"] = 4;
    gltf.document["accessors"].back()["count"] = 3;
    const Scene scene = load();
    EXPECT_TRUE(is_near(corner(scene, 0, 1).position, glm::dvec3(1, 0, 0)));
    EXPECT_TRUE(is_near(corner(scene, 0, 2).position, glm::dvec3(0, -1, 0)));
    EXPECT_TRUE(is_near(corner(scene, 0, 2).normal, glm::dvec3(0, 0, -1)));
    // Not normalised, they are lengths.
    gltf.attribute("POSITION", std::vector<std::int8_t>{0, 0, 0, 0, 100, 0, 0, 0, 0, -7, 0, 0},
                   "VEC3");
    gltf.document["bufferViews"].back()["byteStride"] = 4;
    EXPECT_TRUE(is_near(corner(load(), 0, 1).position, glm::dvec3(100, 0, 0)));
}

TEST_F(GltfInput, TakesColorsOfVerticesForLinear) {
    gltf.attribute("COLOR_0", std::vector<float>{1, 0, 0, 0, 1, 0, 0.2F, 0.4F, 0.6F}, "VEC3");
    expect_colors(load());
    gltf.attribute("COLOR_0",
                   std::vector<std::uint8_t>{255, 0, 0, 255, 0, 255, 0, 255, 51, 102, 153, 255},
                   "VEC4", true);
    expect_colors(load());
    gltf.attribute("COLOR_0",
                   std::vector<std::uint16_t>{65535, 0, 0, 0, 65535, 0, 13107, 26214, 39321},
                   "VEC3", true);
    expect_colors(load());
}

TEST_F(GltfInput, WithoutColorsVerticesAreWhite) {
    EXPECT_EQ(corner(load(), 0, 0).color, glm::dvec3(1));
}

TEST_F(GltfInput, WarnsOfTransparentVertices) {
    gltf.attribute("COLOR_0", std::vector<float>{1, 1, 1, 0.5F, 1, 1, 1, 1, 1, 1, 1, 1}, "VEC4");
    gltf.document["materials"] = {{{"alphaMode", "OPAQUE"}}};
    gltf.primitive()["material"] = 0;
    EXPECT_TRUE(load().warnings.empty());
    gltf.document["materials"][0]["alphaMode"] = "BLEND";
    ASSERT_EQ(load().warnings.size(), 1U);
    EXPECT_NE(load().warnings[0].find("has transparent vertices"), std::string::npos);
}

// The two examples of the extension's specification, and one of a rotation by hand: u goes right
// and v down, so a quarter turn counter-clockwise takes (1, 0) to (0, -1) and (0, 1) to (1, 0).
TEST_F(GltfInput, MovesTextureCoordinates) {
    move_texture({{"offset", {0, 1}}, {"rotation", std::acos(0.0)}, {"scale", {0.5, 0.5}}});
    Scene scene = load();
    EXPECT_TRUE(is_near(corner(scene, 0, 0).texture_coordinates, glm::dvec2(0, 1)));
    EXPECT_TRUE(is_near(corner(scene, 0, 1).texture_coordinates, glm::dvec2(0, 0.5)));
    EXPECT_TRUE(is_near(corner(scene, 0, 2).texture_coordinates, glm::dvec2(0.5, 1)));

    move_texture({{"offset", {0, 1}}, {"scale", {1, -1}}});
    scene = load();
    EXPECT_TRUE(is_near(corner(scene, 0, 0).texture_coordinates, glm::dvec2(0, 1)));
    EXPECT_TRUE(is_near(corner(scene, 0, 2).texture_coordinates, glm::dvec2(0, 0)));

    move_texture({{"offset", {0.25, 0.5}}, {"rotation", std::acos(0.0)}, {"scale", {2, 3}}});
    scene = load();
    EXPECT_TRUE(is_near(corner(scene, 0, 0).texture_coordinates, glm::dvec2(0.25, 0.5)));
    EXPECT_TRUE(is_near(corner(scene, 0, 1).texture_coordinates, glm::dvec2(0.25, -1.5)));
    EXPECT_TRUE(is_near(corner(scene, 0, 2).texture_coordinates, glm::dvec2(3.25, 0.5)));
}

TEST_F(GltfInput, MovesTheTextureCoordinatesThatTheTransformNames) {
    gltf.attribute("TEXCOORD_1", std::vector<float>{0.5F, 0.5F, 1, 1, 0, 0}, "VEC2");
    move_texture({{"offset", {0.25, 0}}, {"texCoord", 1}});
    EXPECT_TRUE(is_near(corner(load(), 0, 0).texture_coordinates, glm::dvec2(0.75, 0.5)));
}

TEST_F(GltfInput, PlacesEveryInstance) {
    const std::size_t translations =
        gltf.accessor(std::vector<float>{1, 0, 0, 2, 0, 0, 3, 0, 0}, "VEC3", 3);
    const std::size_t scales =
        gltf.accessor(std::vector<float>{1, 1, 1, 2, 2, 2, 3, 3, 3}, "VEC3", 3);
    // Half a turn about z, normalised, for the last.
    const std::size_t rotations = gltf.accessor(
        std::vector<std::int16_t>{0, 0, 0, 32767, 0, 0, 0, 32767, 0, 0, 32767, 0}, "VEC4", 4, true);
    gltf.document["nodes"][0]["translation"] = {0, 0, 5};
    gltf.document["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {
        {"TRANSLATION", translations}, {"SCALE", scales}, {"ROTATION", rotations}};
    gltf.document["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
    const Scene scene = load();
    ASSERT_EQ(scene.triangles.size(), 3U);
    EXPECT_TRUE(is_near(corner(scene, 0, 1).position, glm::dvec3(2, 0, 5)));
    EXPECT_TRUE(is_near(corner(scene, 1, 1).position, glm::dvec3(4, 0, 5)));
    EXPECT_TRUE(is_near(corner(scene, 2, 1).position, glm::dvec3(0, 0, 5)));
}

class GltfJoints : public GltfInput {
protected:
    // Two joints: the first stays, the second is moved by 10 along z and turned by a quarter about
    // x. The first corner is the first's, the second the second's, the third is half of each.
    GltfJoints() {
        gltf.attribute("NORMAL", std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
        gltf.attribute("JOINTS_0", std::vector<std::uint8_t>{0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0},
                       "VEC4");
        gltf.attribute("WEIGHTS_0", std::vector<float>{1, 0, 0, 0, 1, 0, 0, 0, 0.5F, 0.5F, 0, 0},
                       "VEC4");
        const double half = std::sqrt(0.5);
        gltf.document["nodes"] = {
            {{"mesh", 0}, {"skin", 0}, {"translation", {100, 100, 100}}},
            {{"name", "joint"}},
            {{"name", "joint"}, {"translation", {0, 0, 10}}, {"rotation", {half, 0, 0, half}}}};
        gltf.document["skins"] = {{{"joints", {1, 2}}}};
        gltf.document["scenes"][0]["nodes"] = {0, 1, 2};
    }

    static void expect_pose(const Scene &scene) {
        ASSERT_EQ(scene.triangles.size(), 1U);
        EXPECT_TRUE(is_near(corner(scene, 0, 0).position, glm::dvec3(0, 0, 0)));
        EXPECT_TRUE(is_near(corner(scene, 0, 1).position, glm::dvec3(1, 0, 10)));
        EXPECT_TRUE(is_near(corner(scene, 0, 2).position, glm::dvec3(0, 0.5, 5.5)));
        EXPECT_TRUE(is_near(corner(scene, 0, 0).normal, glm::dvec3(0, 0, 1)));
        EXPECT_TRUE(is_near(corner(scene, 0, 1).normal, glm::dvec3(0, -1, 0)));
    }
};

TEST_F(GltfJoints, BendTheMeshWhereverItsNodeIs) {
    expect_pose(load());
}

TEST_F(GltfJoints, InOneFile) {
    expect_pose(imported(gltf.write_glb(folder)));
}

TEST_F(GltfJoints, TakeWeightsThatAreBytesAndDoNotAddUpToOne) {
    gltf.attribute("WEIGHTS_0", std::vector<std::uint8_t>{255, 0, 0, 0, 128, 0, 0, 0, 64, 64, 0, 0},
                   "VEC4", true);
    expect_pose(load());
}

TEST_F(GltfJoints, AreMovedFromWhereTheyWereBound) {
    // The first was bound at x = 1, the second at the origin; matrices are in columns.
    gltf.document["skins"][0]["inverseBindMatrices"] =
        gltf.accessor(std::vector<float>{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -1, 0, 0, 1,
                                         1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0,  0, 0, 1},
                      "MAT4", 16);
    const Scene scene = load();
    EXPECT_TRUE(is_near(corner(scene, 0, 0).position, glm::dvec3(-1, 0, 0)));
    EXPECT_TRUE(is_near(corner(scene, 0, 2).position, glm::dvec3(-0.5, 0.5, 5.5)));
}

TEST_F(GltfJoints, OfTwoSkinsBendOneMeshTwice) {
    gltf.document["skins"].push_back({{"joints", {2, 1}}});
    gltf.document["nodes"].push_back({{"mesh", 0}, {"skin", 1}});
    gltf.document["scenes"][0]["nodes"].push_back(3);
    const Scene scene = load();
    ASSERT_EQ(scene.triangles.size(), 2U);
    EXPECT_TRUE(is_near(corner(scene, 0, 1).position, glm::dvec3(1, 0, 10)));
    EXPECT_TRUE(is_near(corner(scene, 1, 1).position, glm::dvec3(1, 0, 0)));
    EXPECT_TRUE(is_near(corner(scene, 1, 0).position, glm::dvec3(0, 0, 10)));
}

TEST_F(GltfInput, TakesShapesOnAsFarAsTheFileSays) {
    const std::size_t shift =
        gltf.accessor(std::vector<float>{0, 0, 1, 0, 0, 2, 0, 0, 3}, "VEC3", 3);
    gltf.primitive()["targets"] = {{{"POSITION", shift}}};
    gltf.document["meshes"][0]["weights"] = {0.5};
    EXPECT_TRUE(is_near(corner(load(), 0, 2).position, glm::dvec3(0, 1, 1.5)));
    gltf.document["nodes"][0]["weights"] = {0};
    EXPECT_TRUE(is_near(corner(load(), 0, 2).position, glm::dvec3(0, 1, 0)));
}

TEST_F(GltfInput, TellsOfAnAnimation) {
    gltf.document["animations"] = {{{"channels", json::array()}, {"samplers", json::array()}}};
    const Scene scene = load();
    ASSERT_EQ(scene.warnings.size(), 1U);
    EXPECT_NE(scene.warnings[0].find("animation isn't drawn"), std::string::npos);
    EXPECT_EQ(scene.warnings[0].rfind("scene.toml:3:1: ", 0), 0U) << scene.warnings[0];
}

TEST_F(GltfInput, RefusesWhatItMustHaveAndIsNotRead) {
    gltf.document["extensionsRequired"] = {"EXT_meshopt_compression"};
    EXPECT_NE(refusal().find("requires EXT_meshopt_compression, which isn't read here, expected a "
                             "file without it: gltfpack"),
              std::string::npos)
        << refusal();
    gltf.document["extensionsRequired"] = {"ACME_holes"};
    EXPECT_NE(refusal().find("requires ACME_holes"), std::string::npos) << refusal();
}

TEST_F(GltfInput, WarnsOfLooksItMustHave) {
    gltf.document["extensionsRequired"] = {"KHR_materials_transmission"};
    const Scene scene = load();
    ASSERT_EQ(scene.warnings.size(), 1U);
    EXPECT_NE(scene.warnings[0].find("KHR_materials_transmission"), std::string::npos);
}

TEST_F(GltfInput, ListsInOneLineWhatMaterialsHaveAndPicturesNot) {
    move_texture(json::object());
    gltf.document["materials"][0]["normalTexture"] = {{"index", 0}};
    gltf.document["materials"][0]["extensions"]["KHR_materials_clearcoat"] = json::object();
    const Scene scene = load();
    ASSERT_EQ(scene.warnings.size(), 1U);
    EXPECT_NE(scene.warnings[0].find("isn't drawn: KHR_materials_clearcoat, a normal map"),
              std::string::npos)
        << scene.warnings[0];
}

// Each is damaged in one way, and refused in one line or read, without a crash of ours.
TEST_F(GltfInput, DamagedNumbersAreRefused) {
    gltf.attribute("TEXCOORD_0", std::vector<std::uint16_t>{0, 0, 65535, 0, 0, 65535}, "VEC2",
                   true);
    json &accessor = gltf.document["accessors"].back();
    for (const auto &[key, value] :
         std::initializer_list<std::pair<const char *, json>>{{"count", 1'000'000'000},
                                                              {"byteOffset", 1 << 20},
                                                              {"bufferView", 99},
                                                              {"componentType", 1},
                                                              {"count", -1}}) {
        const json before = accessor;
        accessor[key] = value;
        EXPECT_NE(refusal(), "") << key;
        EXPECT_EQ(refusal().find("went astray"), std::string::npos) << key;
        accessor = before;
    }
}

}  // namespace
}  // namespace stagelight
