// SPDX-License-Identifier: MIT
#include "scene/lessons.h"

#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "scene/messages.h"

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
    for (const Lesson &lesson : lessons_of(scene)) {
        lines.push_back(
            fmt::format("{} {} {}", lesson.first_stage, lesson.what, to_string(lesson.where)));
    }
    return lines;
}

using Lines = std::vector<std::string>;

TEST(Lessons, AnEmptySceneAsksForNone) {
    EXPECT_EQ(told(Scene{}), Lines{});
    EXPECT_NO_THROW(require_learnt(Scene{}, 1));
}

TEST(Lessons, WhiteSpheresAndPlanesAreTheFirst) {
    Scene scene = white_spheres();
    scene.planes.push_back({.where = line(7)});
    EXPECT_EQ(told(scene), (Lines{"1 sphere a.toml:4:1", "1 plane a.toml:7:1"}));
    EXPECT_NO_THROW(require_learnt(scene, 1));
}

TEST(Lessons, LightsAreTheSecond) {
    Scene scene = white_spheres();
    scene.lights.push_back({.where = line(12)});
    scene.lights.push_back({.where = line(2)});
    EXPECT_EQ(told(scene), (Lines{"1 sphere a.toml:4:1", "2 light a.toml:2:1"}));
}

TEST(Lessons, EachTypeOfMaterialHasItsStage) {
    const auto of = [](MaterialType type) { return told(sphere_of(type)).back(); };
    EXPECT_EQ(of(MaterialType::diffuse), "2 diffuse material a.toml:20:1");
    EXPECT_EQ(of(MaterialType::mirror), "3 mirror material a.toml:20:1");
    EXPECT_EQ(of(MaterialType::glossy), "3 glossy material a.toml:20:1");
    EXPECT_EQ(of(MaterialType::dielectric), "4 dielectric material a.toml:20:1");
}

TEST(Lessons, PlanesUseMaterialsToo) {
    Scene scene;
    scene.materials.push_back({.type = MaterialType::mirror, .where = line(20)});
    scene.planes.push_back({.where = line(7)});
    EXPECT_EQ(told(scene).back(), "3 mirror material a.toml:20:1");
}

TEST(Lessons, OnlyMaterialsThatShapesUseCount) {
    Scene scene = white_spheres();
    scene.textures.emplace_back();
    scene.materials.push_back({.type = MaterialType::dielectric, .where = line(20)});
    scene.materials.push_back({.texture = 0, .where = line(21)});
    EXPECT_EQ(told(scene), Lines{"1 sphere a.toml:4:1"});
}

TEST(Lessons, OfSeveralMaterialsTheFirstInTheFileIsNamed) {
    Scene scene = sphere_of(MaterialType::mirror);
    scene.materials.push_back({.type = MaterialType::mirror, .where = line(15)});
    scene.spheres.push_back({.material = 1, .where = line(5)});
    EXPECT_EQ(told(scene).back(), "3 mirror material a.toml:15:1");
}

TEST(Lessons, MeshesAreTheFifth) {
    EXPECT_EQ(told(triangle_of(MaterialType::diffuse)),
              (Lines{"2 diffuse material a.toml:20:1", "5 mesh a.toml:6:1"}));
    EXPECT_EQ(told(triangle_of(MaterialType::diffuse, 0)), Lines{"5 mesh a.toml:6:1"});
}

TEST(Lessons, TexturesAreTheSixth) {
    Scene scene = sphere_of(MaterialType::diffuse);
    scene.textures.emplace_back().where = line(22);
    scene.materials[0].texture = 0;
    EXPECT_EQ(told(scene).back(), "6 texture a.toml:22:1");
}

TEST(Lessons, RefractionInMeshesIsTheTenth) {
    EXPECT_EQ(told(triangle_of(MaterialType::dielectric)),
              (Lines{"4 dielectric material a.toml:20:1", "5 mesh a.toml:6:1",
                     "11 dielectric mesh a.toml:6:1"}));
}

TEST(Lessons, GlassBesideAMeshIsNotRefractionInIt) {
    Scene scene = triangle_of(MaterialType::diffuse);
    scene.materials.push_back({.type = MaterialType::dielectric, .where = line(21)});
    scene.spheres.push_back({.material = 1, .where = line(8)});
    EXPECT_EQ(told(scene).back(), "5 mesh a.toml:6:1");
}

TEST(Lessons, AStageRefusesWhatItHasNotLearnt) {
    const Scene scene = sphere_of(MaterialType::dielectric);
    EXPECT_EQ(message_of([&] { require_learnt(scene, 2); }),
              "a.toml:20:1: a dielectric material: 02_shading_shadows has not learnt that yet; "
              "04_refraction_beer is the first stage that can draw it");
    EXPECT_NE(message_of([&] { require_learnt(scene, 3); }), "");
    EXPECT_EQ(message_of([&] { require_learnt(scene, 4); }), "");
    EXPECT_EQ(message_of([&] { require_learnt(scene, 11); }), "");
}

TEST(Lessons, OfSeveralLessonsTheLastIsNamed) {
    EXPECT_EQ(message_of([&] { require_learnt(triangle_of(MaterialType::dielectric), 1); }),
              "a.toml:6:1: a dielectric mesh: 01_primitives has not learnt that yet; "
              "11_full_tracer is the first stage that can draw it");
}

TEST(Lessons, StagesAreNamedInOrder) {
    for (std::size_t i = 0; i < stage_names.size(); ++i) {
        const std::string number = fmt::format("{:02}_", i + 1);
        EXPECT_EQ(stage_names[i].substr(0, 3), number) << "of " << stage_names[i];
    }
}

}  // namespace
}  // namespace stagelight
