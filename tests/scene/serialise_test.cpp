// SPDX-License-Identifier: MIT
// What a sandbox hands back may be anything: an index that points past the end must not be taken.
#include "scene/serialise.h"

#include <functional>

#include <gtest/gtest.h>

namespace stagelight {
namespace {

const SourceLocation here{"scene.toml", 3, 1};

// Of no scene: two triangles over four vertices, a material and a texture.
Scene sound_scene() {
    Scene scene;
    scene.vertices.resize(4);
    scene.vertices[3].position = {1, 2, 3};
    scene.vertices[3].color = {0.5, 0.25, 0.125};
    scene.meshes.push_back({.file = "a.obj", .where = here});
    scene.materials.push_back(
        {.color = {1, 0.5, 0.25}, .texture = 0, .alpha_cutoff = 0.25, .where = here});
    scene.triangles.push_back({.vertices = {0, 1, 2}});
    scene.triangles.push_back({.vertices = {1, 2, 3}});
    scene.textures.push_back({.file = "a.png",
                              .wrap_u = Wrap::clamp,
                              .wrap_v = Wrap::mirror,
                              .width = 2,
                              .height = 1,
                              .texels = {1, 2, 3, 4, 5, 6, 7, 8},
                              .where = here});
    scene.warnings = {"a.obj: no file b.png", ""};
    return scene;
}

// A scene that has a mesh already, with the bytes of `scene` appended.
bool is_taken(const Scene &scene, Scene &into) {
    const std::string bytes = serialise_since(SceneSizes(Scene{}), scene);
    into = {};
    into.meshes.push_back({.file = "a.obj", .where = here});
    return append_serialised(into, bytes, here);
}

bool is_taken_with(const std::function<void(Scene &)> &change) {
    Scene scene = sound_scene();
    change(scene);
    Scene into;
    return is_taken(scene, into);
}

TEST(Serialise, BringsAScenePartBack) {
    Scene scene;
    ASSERT_TRUE(is_taken(sound_scene(), scene));
    EXPECT_EQ(scene.vertices.size(), 4U);
    EXPECT_EQ(scene.vertices[3].position, glm::dvec3(1, 2, 3));
    ASSERT_EQ(scene.triangles.size(), 2U);
    EXPECT_EQ(scene.triangles[1].vertices, (std::array<std::uint32_t, 3>{1, 2, 3}));
    ASSERT_EQ(scene.materials.size(), 1U);
    EXPECT_EQ(scene.materials[0].color, glm::dvec3(1, 0.5, 0.25));
    EXPECT_EQ(scene.vertices[3].color, glm::dvec3(0.5, 0.25, 0.125));
    EXPECT_EQ(scene.materials[0].alpha_cutoff, 0.25);
    ASSERT_EQ(scene.textures.size(), 1U);
    EXPECT_EQ(scene.textures[0].wrap_u, Wrap::clamp);
    EXPECT_EQ(scene.textures[0].wrap_v, Wrap::mirror);
    EXPECT_EQ(scene.textures[0].texels, sound_scene().textures[0].texels);
    EXPECT_EQ(scene.textures[0].file, "a.png");
    EXPECT_EQ(scene.textures[0].where.column, 1U);
    EXPECT_EQ(scene.warnings, sound_scene().warnings);
}

TEST(Serialise, RefusesWhatPointsPastTheEnd) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
        EXPECT_FALSE(is_taken_with([=](Scene &s) { s.triangles[1].vertices[corner] = 4; }))
            << "vertex " << corner;
    }
    EXPECT_FALSE(is_taken_with([](Scene &s) { s.triangles[1].material = 1; }));
    EXPECT_FALSE(is_taken_with([](Scene &s) { s.triangles[1].material = -1; }));
    EXPECT_FALSE(is_taken_with([](Scene &s) { s.triangles[1].mesh = 1; }));
    EXPECT_FALSE(is_taken_with([](Scene &s) { s.materials[0].texture = 1; }));
    EXPECT_TRUE(is_taken_with([](Scene &s) { s.materials[0].texture = no_texture; }));
}

TEST(Serialise, RefusesATextureOfAnotherSize) {
    EXPECT_FALSE(is_taken_with([](Scene &s) { s.textures[0].width = 3; }));
    EXPECT_FALSE(is_taken_with([](Scene &s) { s.textures[0].height = 2; }));
    EXPECT_FALSE(is_taken_with([](Scene &s) { s.textures[0].wrap_u = static_cast<Wrap>(3); }));
    EXPECT_FALSE(is_taken_with([](Scene &s) { s.textures[0].texels.pop_back(); }));
    EXPECT_FALSE(is_taken_with([](Scene &s) {
        s.textures[0].width = 0;
        s.textures[0].texels.clear();
    }));
    const std::string bytes = serialise(sound_scene().textures[0]);
    EXPECT_TRUE(deserialise_texture(bytes));
    EXPECT_FALSE(deserialise_texture(bytes + '\0'));
}

// Cut anywhere, or with more behind its end.
TEST(Serialise, RefusesWhatIsNotWhole) {
    const std::string bytes = serialise_since(SceneSizes(Scene{}), sound_scene());
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        Scene scene;
        scene.meshes.push_back({.file = "a.obj", .where = here});
        EXPECT_FALSE(append_serialised(scene, std::string_view(bytes).substr(0, size), here))
            << size;
    }
    Scene scene;
    scene.meshes.push_back({.file = "a.obj", .where = here});
    EXPECT_FALSE(append_serialised(scene, bytes + '\0', here));
}

}  // namespace
}  // namespace stagelight
