// SPDX-License-Identifier: MIT
// What of a mesh is there, where its textures lie, and how they go on beyond their edges.
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "scene/gltf_writer.h"
#include "scene/import.h"
#include "scene/near.h"
#include "scene/texture_alpha.h"

namespace stagelight {
namespace {

using nlohmann::json;

// A TGA of 32 bits, its rows from the top, with these colours: blue, green, red and alpha.
std::string tga(int width, int height, const std::string &texels) {
    std::string header(18, '\0');
    header[2] = 2;
    header[12] = static_cast<char>(width);
    header[14] = static_cast<char>(height);
    header[16] = 32;
    header[17] = 0x28;
    return header + texels;
}

std::string texel(int blue, int green, int red, int alpha) {
    return {static_cast<char>(blue), static_cast<char>(green), static_cast<char>(red),
            static_cast<char>(alpha)};
}

class MtlAlpha : public testing::Test {
protected:
    // Two triangles, of materials a and b.
    Scene load(const std::string &materials) const {
        folder.write("a.mtl", materials);
        return imported(folder.write("a.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n"
                                              "vt 0 0\nvt 1 0\nvt 0 1\nusemtl a\nf 1/1 2/2 3/3\n"
                                              "usemtl b\nf 2/2 4/1 3/3\n"));
    }

    TemporaryFolder folder;
};

TEST_F(MtlAlpha, WhatCannotBeSeenIsNotThere) {
    for (const char *unseen : {"d 0", "d 0.0", "Tr 1"}) {
        const Scene scene = load(std::string("newmtl a\n") + unseen + "\nnewmtl b\nKd 1 0 0\n");
        ASSERT_EQ(scene.triangles.size(), 1U) << unseen;
        ASSERT_EQ(scene.materials.size(), 1U) << unseen;
        EXPECT_EQ(scene.materials[0].color, glm::dvec3(1, 0, 0));
        EXPECT_TRUE(scene.warnings.empty());
    }
}

// Some programs write Tr as if it were d.
TEST_F(MtlAlpha, OpacityIsBelievedBeforeTransparency) {
    EXPECT_EQ(load("newmtl a\nd 1\nTr 1\nnewmtl b\nTr 1\nd 1\n").triangles.size(), 2U);
}

TEST_F(MtlAlpha, AMeshThatIsNotThereIsTold) {
    const Scene scene = load("newmtl a\nd 0\nnewmtl b\nd 0\n");
    EXPECT_TRUE(scene.triangles.empty());
    ASSERT_EQ(scene.warnings.size(), 1U);
    EXPECT_NE(scene.warnings[0].find("nothing is drawn"), std::string::npos);
}

TEST_F(MtlAlpha, BlendingIsToldOnce) {
    const Scene scene = load("newmtl a\nd 0.5\nnewmtl b\nd 0.3\n");
    EXPECT_EQ(scene.triangles.size(), 2U);
    ASSERT_EQ(scene.warnings.size(), 1U);
    EXPECT_NE(scene.warnings[0].find("isn't blended"), std::string::npos);
}

TEST_F(MtlAlpha, OnlyWhatATextureLeavesOutIsCut) {
    folder.write("holes.tga", tga(2, 1, texel(1, 2, 3, 255) + texel(1, 2, 3, 0)));
    folder.write("glass.tga", tga(2, 1, texel(1, 2, 3, 255) + texel(1, 2, 3, 9)));
    folder.write("solid.tga", tga(2, 1, texel(1, 2, 3, 255) + texel(1, 2, 3, 255)));
    folder.write("none.tga", tga(2, 1, texel(1, 2, 3, 0) + texel(1, 2, 3, 0)));
    const Scene holes = load("newmtl a\nmap_Kd holes.tga\nnewmtl b\n");
    EXPECT_DOUBLE_EQ(holes.materials.at(0).alpha_cutoff, 0.5 / 255);
    EXPECT_TRUE(holes.warnings.empty());
    const Scene glass = load("newmtl a\nmap_Kd glass.tga\nnewmtl b\n");
    EXPECT_EQ(glass.materials.at(0).alpha_cutoff, 0);
    EXPECT_EQ(glass.warnings.size(), 1U);
    for (const char *picture : {"solid.tga", "none.tga"}) {
        const Scene solid = load(std::string("newmtl a\nmap_Kd ") + picture + "\nnewmtl b\n");
        EXPECT_EQ(solid.materials.at(0).alpha_cutoff, 0) << picture;
        EXPECT_TRUE(solid.warnings.empty()) << picture;
    }
}

TEST_F(MtlAlpha, AMaskBecomesTheTexturesAlpha) {
    folder.write("color.tga", tga(1, 1, texel(10, 20, 30, 255)));
    folder.write("mask.tga", tga(2, 1, texel(255, 255, 255, 255) + texel(0, 0, 0, 255)));
    const Scene scene = load("newmtl a\nmap_Kd color.tga\nmap_d mask.tga\nnewmtl b\n");
    ASSERT_EQ(scene.textures.size(), 1U) << "neither of the two by itself";
    EXPECT_EQ(scene.textures[0].width, 2);
    EXPECT_EQ(scene.textures[0].texels,
              (std::vector<std::uint8_t>{30, 20, 10, 255, 30, 20, 10, 0}));
    EXPECT_DOUBLE_EQ(scene.materials.at(0).alpha_cutoff, 0.5 / 255);
}

TEST_F(MtlAlpha, AMaskAloneIsWhite) {
    folder.write("mask.tga", tga(2, 1, texel(9, 9, 9, 0) + texel(9, 9, 9, 255)));
    const Scene scene = load("newmtl a\nKd 1 0 0\nmap_d -clamp on mask.tga\nnewmtl b\n"
                             "map_d -clamp on mask.tga\n");
    ASSERT_EQ(scene.textures.size(), 1U);
    EXPECT_EQ(scene.textures[0].texels,
              (std::vector<std::uint8_t>{255, 255, 255, 0, 255, 255, 255, 255}))
        << "by its alpha, since it has one";
    EXPECT_EQ(scene.textures[0].wrap_u, Wrap::clamp);
    EXPECT_EQ(scene.materials.at(0).color, glm::dvec3(1, 0, 0));
    EXPECT_EQ(scene.materials.at(1).texture, 0);
}

TEST_F(MtlAlpha, TexturesAreMovedAsTheirLineSays) {
    folder.write("a b.tga", tga(1, 1, texel(1, 2, 3, 255)));
    const Scene scene =
        load("newmtl a\nmap_Kd -s 2 3 1 -blendu on -o 0.25 0.5 -mm 0 1 a b.tga\nnewmtl b\n");
    ASSERT_EQ(scene.textures.size(), 1U);
    const auto at = [&](std::size_t i) {
        return scene.vertices.at(scene.triangles.at(0).vertices.at(i)).texture_coordinates;
    };
    // (0, 0), (1, 0) and (0, 1), v going up, times (2, 3) and moved; then v goes down.
    EXPECT_TRUE(is_near(at(0), glm::dvec2(0.25, 0.5)));
    EXPECT_TRUE(is_near(at(1), glm::dvec2(2.25, 0.5)));
    EXPECT_TRUE(is_near(at(2), glm::dvec2(0.25, -2.5)));
}

TEST_F(MtlAlpha, ATextureThatEndsInTwoWaysIsTwo) {
    folder.write("c.tga", tga(1, 1, texel(1, 2, 3, 255)));
    Scene scene = load("newmtl a\nmap_Kd c.tga\nnewmtl b\nmap_Kd -clamp on c.tga\n");
    ASSERT_EQ(scene.textures.size(), 2U);
    EXPECT_EQ(scene.textures[0].wrap_u, Wrap::repeat);
    EXPECT_EQ(scene.textures[1].wrap_u, Wrap::clamp);
    EXPECT_EQ(scene.textures[1].wrap_v, Wrap::clamp);
    EXPECT_EQ(scene.textures[1].texels, scene.textures[0].texels);
    EXPECT_EQ(scene.materials.at(1).texture, 1);
    import_mesh(scene, folder.path() / "a.obj", {}, material_of_file, mesh_entry);
    EXPECT_EQ(scene.textures.size(), 2U) << "both are known";
}

class GltfAlpha : public testing::Test {
protected:
    GltfAlpha() {
        gltf.attribute("TEXCOORD_0", std::vector<float>{0, 0, 1, 0, 0, 1}, "VEC2");
        folder.write("c.tga", tga(2, 1, texel(1, 2, 3, 100) + texel(1, 2, 3, 255)));
        gltf.document["images"] = {{{"uri", "c.tga"}}};
        gltf.document["textures"] = {{{"source", 0}, {"sampler", 0}}};
        gltf.document["samplers"] = {json::object()};
        gltf.document["materials"] = {
            {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
        gltf.primitive()["material"] = 0;
    }

    Scene load() { return imported(gltf.write(folder)); }
    json &material() { return gltf.document["materials"][0]; }

    TemporaryFolder folder;
    GltfWriter gltf;
};

TEST_F(GltfAlpha, OpaqueIgnoresIt) {
    material()["pbrMetallicRoughness"]["baseColorFactor"] = {1, 1, 1, 0};
    const Scene scene = load();
    EXPECT_EQ(scene.triangles.size(), 1U);
    EXPECT_EQ(scene.materials.at(0).alpha_cutoff, 0);
    EXPECT_TRUE(scene.warnings.empty());
}

TEST_F(GltfAlpha, MaskKeepsItsThreshold) {
    material()["alphaMode"] = "MASK";
    EXPECT_DOUBLE_EQ(load().materials.at(0).alpha_cutoff, 0.5);
    material()["alphaCutoff"] = 0.75;
    material()["pbrMetallicRoughness"]["baseColorFactor"] = {1, 1, 1, 0.8};
    EXPECT_NEAR(load().materials.at(0).alpha_cutoff, 0.75 / 0.8, 1e-6);
    EXPECT_TRUE(load().warnings.empty());
}

TEST_F(GltfAlpha, MaskThatNoTexelComesUpToLeavesNothing) {
    material()["alphaMode"] = "MASK";
    material()["pbrMetallicRoughness"]["baseColorFactor"] = {1, 1, 1, 0.25};
    EXPECT_TRUE(load().triangles.empty());
}

TEST_F(GltfAlpha, MaskCutsNothingOffATextureThatIsAllAboveIt) {
    material()["alphaMode"] = "MASK";
    material()["alphaCutoff"] = 0.25;
    EXPECT_EQ(load().materials.at(0).alpha_cutoff, 0);
}

TEST_F(GltfAlpha, BlendIsTold) {
    material()["alphaMode"] = "BLEND";
    const Scene scene = load();
    EXPECT_EQ(scene.materials.at(0).alpha_cutoff, 0);
    ASSERT_EQ(scene.warnings.size(), 1U);
    material()["pbrMetallicRoughness"]["baseColorFactor"] = {1, 1, 1, 0};
    EXPECT_TRUE(load().triangles.empty());
}

TEST_F(GltfAlpha, SamplersSayHowTexturesGoOn) {
    gltf.document["samplers"][0] = {{"wrapS", 33071}, {"wrapT", 33648}};
    const Scene scene = load();
    ASSERT_EQ(scene.textures.size(), 1U);
    EXPECT_EQ(scene.textures[0].wrap_u, Wrap::clamp);
    EXPECT_EQ(scene.textures[0].wrap_v, Wrap::mirror);
    gltf.document["samplers"][0] = json::object();
    EXPECT_EQ(load().textures.at(0).wrap_u, Wrap::repeat);
}

TEST(TextureAlpha, IsBetweenTheTexelsOfASmallerMask) {
    Texture color;
    color.width = 4;
    color.height = 1;
    color.texels.assign(16, 7);
    Texture mask;
    mask.width = 2;
    mask.height = 1;
    mask.texels = {0, 0, 0, 255, 200, 200, 200, 255};
    const Texture both = with_alpha(color, mask);
    // Texel centres at 1/8, 3/8, 5/8 and 7/8 of the width, the mask's at 1/4 and 3/4; it repeats.
    EXPECT_EQ(both.texels[3], 50);
    EXPECT_EQ(both.texels[7], 50);
    EXPECT_EQ(both.texels[11], 150);
    EXPECT_EQ(both.texels[15], 150);
    EXPECT_EQ(both.texels[4], 7);
}

}  // namespace
}  // namespace stagelight
