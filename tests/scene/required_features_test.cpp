// SPDX-License-Identifier: MIT
#include "scene/required_features.h"

#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "scene/messages.h"
#include "scene/stages.h"

namespace stagelight {
namespace {

SourceLocation line(unsigned number) {
    return {"a.toml", number, 1};
}

// The plain white material of shapes that name none is 0.
Scene white_spheres() {
    Scene scene;
    scene.materials.emplace_back();
    scene.spheres.push_back({.where = line(9)});
    scene.spheres.push_back({.where = line(4)});
    return scene;
}

// A sphere of a material that is written in line 20.
Scene sphere_of(MaterialType type) {
    Scene scene;
    scene.materials.push_back({.type = type, .where = line(20)});
    scene.spheres.push_back({.where = line(4)});
    return scene;
}

// A triangle of a material that is written in line 20, or of the plain white one.
Scene triangle_of(MaterialType type, unsigned material_line = 20) {
    Scene scene;
    scene.materials.push_back({.type = type, .where = line(material_line)});
    scene.meshes.push_back({.file = "a.obj", .where = line(6)});
    scene.vertices.resize(3);
    scene.triangles.push_back({.vertices = {0, 1, 2}});
    return scene;
}

std::vector<std::string> told(const Scene &scene) {
    std::vector<std::string> lines;
    for (const RequiredFeature &feature : required_features(scene)) {
        lines.push_back(
            fmt::format("{} {} {}", feature.first_stage, feature.what, to_string(feature.where)));
    }
    return lines;
}

using Lines = std::vector<std::string>;

TEST(RequiredFeatures, AnEmptySceneAsksForNone) {
    EXPECT_EQ(told(Scene{}), Lines{});
    EXPECT_NO_THROW(require_supported(Scene{}, 1));
}

TEST(RequiredFeatures, WhiteSpheresAndPlanesAreTheFirst) {
    Scene scene = white_spheres();
    scene.planes.push_back({.where = line(7)});
    EXPECT_EQ(told(scene), (Lines{"1 sphere a.toml:4:1", "1 plane a.toml:7:1"}));
    EXPECT_NO_THROW(require_supported(scene, 1));
}

TEST(RequiredFeatures, LightsAreTheSecond) {
    Scene scene = white_spheres();
    scene.lights.push_back({.where = line(12)});
    scene.lights.push_back({.where = line(2)});
    EXPECT_EQ(told(scene), (Lines{"1 sphere a.toml:4:1", "2 light a.toml:2:1"}));
}

TEST(RequiredFeatures, EachTypeOfMaterialHasItsStage) {
    const auto of = [](MaterialType type) { return told(sphere_of(type)).back(); };
    EXPECT_EQ(of(MaterialType::diffuse), "2 diffuse material a.toml:20:1");
    EXPECT_EQ(of(MaterialType::mirror), "3 mirror material a.toml:20:1");
    EXPECT_EQ(of(MaterialType::glossy), "3 glossy material a.toml:20:1");
    EXPECT_EQ(of(MaterialType::dielectric), "4 dielectric material a.toml:20:1");
}

TEST(RequiredFeatures, PlanesUseMaterialsToo) {
    Scene scene;
    scene.materials.push_back({.type = MaterialType::mirror, .where = line(20)});
    scene.planes.push_back({.where = line(7)});
    EXPECT_EQ(told(scene).back(), "3 mirror material a.toml:20:1");
}

TEST(RequiredFeatures, OnlyMaterialsThatShapesUseCount) {
    Scene scene = white_spheres();
    scene.textures.emplace_back();
    scene.materials.push_back({.type = MaterialType::dielectric, .where = line(20)});
    scene.materials.push_back({.texture = 0, .where = line(21)});
    EXPECT_EQ(told(scene), Lines{"1 sphere a.toml:4:1"});
}

TEST(RequiredFeatures, OfSeveralMaterialsTheFirstInTheFileIsNamed) {
    Scene scene = sphere_of(MaterialType::mirror);
    scene.materials.push_back({.type = MaterialType::mirror, .where = line(15)});
    scene.spheres.push_back({.material = 1, .where = line(5)});
    EXPECT_EQ(told(scene).back(), "3 mirror material a.toml:15:1");
}

TEST(RequiredFeatures, MeshesAreTheFifth) {
    EXPECT_EQ(told(triangle_of(MaterialType::diffuse)),
              (Lines{"2 diffuse material a.toml:20:1", "5 mesh a.toml:6:1"}));
    EXPECT_EQ(told(triangle_of(MaterialType::diffuse, 0)), Lines{"5 mesh a.toml:6:1"});
}

TEST(RequiredFeatures, TexturesAreTheSixth) {
    Scene scene = sphere_of(MaterialType::diffuse);
    scene.textures.emplace_back().where = line(22);
    scene.materials[0].texture = 0;
    EXPECT_EQ(told(scene).back(), "6 texture a.toml:22:1");
}

TEST(RequiredFeatures, WrapsAndCutOutsAreTheSixthToo) {
    Scene scene = triangle_of(MaterialType::diffuse);
    scene.textures.emplace_back().where = line(22);
    scene.textures[0].wrap_v = Wrap::clamp;
    scene.materials[0].texture = 0;
    scene.materials[0].alpha_cutoff = 0.5;
    const Lines lines = told(scene);
    ASSERT_EQ(lines.size(), 5U);
    EXPECT_EQ(Lines(lines.begin() + 2, lines.end()),
              (Lines{"6 texture a.toml:22:1", "6 clamped or mirrored texture a.toml:22:1",
                     "6 cut-out a.toml:20:1"}));
}

// A stage before 06 draws the mesh in its material's colour, and says so.
TEST(RequiredFeatures, ColorsOfVerticesCanBeDoneWithout) {
    Scene scene = triangle_of(MaterialType::diffuse);
    EXPECT_EQ(take_out_unsupported(scene, 5), Lines{});
    scene.vertices[1].color = {1, 0.5, 1};
    EXPECT_EQ(told(scene).back(), "6 mesh with colours of vertices a.toml:6:1");
    EXPECT_NO_THROW(require_supported(scene, 5));
    EXPECT_EQ(take_out_unsupported(scene, 6), Lines{});
    EXPECT_TRUE(has_vertex_colors(scene));
    EXPECT_EQ(take_out_unsupported(scene, 5),
              Lines{"a.toml:6:1: a mesh with colours of vertices: drawn without them by 05_meshes; "
                    "06_textures is the first stage that has them"});
    EXPECT_FALSE(has_vertex_colors(scene));
}

TEST(RequiredFeatures, RefractionInMeshesIsTheEleventh) {
    EXPECT_EQ(told(triangle_of(MaterialType::dielectric)),
              (Lines{"4 dielectric material a.toml:20:1", "5 mesh a.toml:6:1",
                     "11 dielectric mesh a.toml:6:1"}));
}

TEST(RequiredFeatures, GlassBesideAMeshIsNotRefractionInIt) {
    Scene scene = triangle_of(MaterialType::diffuse);
    scene.materials.push_back({.type = MaterialType::dielectric, .where = line(21)});
    scene.spheres.push_back({.material = 1, .where = line(8)});
    EXPECT_EQ(told(scene).back(), "5 mesh a.toml:6:1");
}

TEST(RequiredFeatures, AStageRefusesWhatItDoesNotSupport) {
    const Scene scene = sphere_of(MaterialType::dielectric);
    EXPECT_EQ(message_of([&] { require_supported(scene, 2); }),
              "a.toml:20:1: a dielectric material: unsupported by 02_shading_shadows; "
              "04_refraction_beer is the first stage that can draw it");
    EXPECT_NE(message_of([&] { require_supported(scene, 3); }), "");
    EXPECT_EQ(message_of([&] { require_supported(scene, 4); }), "");
    EXPECT_EQ(message_of([&] { require_supported(scene, 11); }), "");
}

TEST(RequiredFeatures, OfSeveralTheLastIsNamed) {
    EXPECT_EQ(message_of([&] { require_supported(triangle_of(MaterialType::dielectric), 1); }),
              "a.toml:6:1: a dielectric mesh: unsupported by 01_primitives; "
              "11_full_tracer is the first stage that can draw it");
}

}  // namespace
}  // namespace stagelight
