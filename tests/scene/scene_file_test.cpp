// SPDX-License-Identifier: MIT
// Scenes as they should be: every key, every default, odd names.
#include "scene/scene_file.h"

#include <cmath>
#include <limits>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "scene/temporary_folder.h"

namespace stagelight {
namespace {

constexpr std::string_view camera = "[camera]\nposition = [0, 1, 4]\nlook_at = [0, 0.5, 0]\n";
constexpr std::string_view red_picture("P6 1 1 255 \xff\0\0", 14);
constexpr std::string_view triangle =
    "v 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n";

class SceneFile : public testing::Test {
protected:
    Scene load(std::string_view text) const {
        return load_scene(folder.write("scene.toml", std::string(camera) + std::string(text)));
    }
    std::string at(unsigned line, unsigned column) const {
        return to_string({(folder.path() / "scene.toml").string(), line, column});
    }

    TemporaryFolder folder;
};

void expect_near(const glm::dvec3 &is, const glm::dvec3 &expected) {
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(is[i], expected[i], 1e-15) << "component " << i;
    }
}

TEST_F(SceneFile, DefaultsOfAScene) {
    const Scene scene = load("");
    EXPECT_EQ(scene.file, folder.path() / "scene.toml");
    EXPECT_EQ(scene.width, 640);
    EXPECT_EQ(scene.height, 384);
    EXPECT_EQ(scene.camera.position, glm::dvec3(0, 1, 4));
    EXPECT_EQ(scene.camera.look_at, glm::dvec3(0, 0.5, 0));
    EXPECT_EQ(scene.camera.up, glm::dvec3(0, 1, 0));
    EXPECT_EQ(scene.camera.fov, 60);
    EXPECT_EQ(scene.background, glm::dvec3(0));
    EXPECT_EQ(scene.max_depth, 8);
    EXPECT_FALSE(scene.has_max_depth);
    EXPECT_EQ(scene.materials.size(), 1U) << "expected plain white, for a buffer can't be empty";
    EXPECT_TRUE(scene.spheres.empty() && scene.planes.empty() && scene.meshes.empty()
                && scene.lights.empty() && scene.textures.empty());
}

TEST_F(SceneFile, SettingsOfAScene) {
    const Scene scene = load(R"(up = [0, 0, -2]
fov = 59.5
[image]
size = [16384, 1]
[background]
color = [0.25, 1, 20]
[trace]
max_depth = 0
)");
    EXPECT_EQ(scene.width, 16384);
    EXPECT_EQ(scene.height, 1);
    EXPECT_EQ(scene.camera.up, glm::dvec3(0, 0, -1));
    EXPECT_EQ(scene.camera.fov, 59.5);
    EXPECT_EQ(scene.background, glm::dvec3(0.25, 1, 20));
    EXPECT_EQ(scene.max_depth, 0);
    EXPECT_TRUE(scene.has_max_depth);
}

TEST_F(SceneFile, ShapesWithoutAMaterialShareAPlainWhiteOne) {
    const Scene scene = load(R"([materials.unused]
type = "mirror"
[[spheres]]
center = [1, 2, 3]
radius = 0.5
[[planes]]
normal = [0, 1, 0]
point = [0, -2, 0]
)");
    ASSERT_EQ(scene.materials.size(), 2U);
    const Material &white = scene.materials[1];
    EXPECT_EQ(white.type, MaterialType::diffuse);
    EXPECT_EQ(white.color, glm::dvec3(1));
    EXPECT_EQ(white.texture, no_texture);
    EXPECT_EQ(white.where.line, 0U) << "expected no place for a material that no one wrote";
    EXPECT_EQ(scene.spheres.at(0).material, 1);
    EXPECT_EQ(scene.planes.at(0).material, 1);
}

TEST_F(SceneFile, SpheresAndPlanes) {
    const Scene scene = load(R"([materials.a]
type = "diffuse"
[materials.b]
type = "mirror"
  [[spheres]]
  center = [1, 2.5, -3]
  radius = 0.5
  material = "b"
[[spheres]]
center = [1e18, -1e18, 0]
radius = 1e18
material = "a"
[[planes]]
normal = [0, 3, 4]
point = [0, -2, 0]
material = "b"
)");
    ASSERT_EQ(scene.materials.size(), 2U);
    EXPECT_EQ(to_string(scene.materials[1].where), at(6, 1));
    ASSERT_EQ(scene.spheres.size(), 2U);
    EXPECT_EQ(scene.spheres[0].center, glm::dvec3(1, 2.5, -3));
    EXPECT_EQ(scene.spheres[0].radius, 0.5);
    EXPECT_EQ(scene.spheres[0].material, 1);
    EXPECT_EQ(to_string(scene.spheres[0].where), at(8, 3));
    EXPECT_EQ(scene.spheres[1].radius, 1e18);
    EXPECT_EQ(scene.spheres[1].material, 0);
    ASSERT_EQ(scene.planes.size(), 1U);
    expect_near(scene.planes[0].normal, {0, 0.6, 0.8});
    EXPECT_EQ(scene.planes[0].point, glm::dvec3(0, -2, 0));
    EXPECT_EQ(scene.planes[0].material, 1);
    EXPECT_EQ(to_string(scene.planes[0].where), at(16, 1));
}

TEST_F(SceneFile, MaterialsOfEveryType) {
    const Scene scene = load(R"([materials]
d = {type = "diffuse", color = [0, 0.5, 1]}
e = {type = "dielectric", ior = 1.33, absorption = [0, 0.8, 12]}
f = {type = "dielectric"}
g = {type = "glossy", specularity = 0.25}
h = {type = "glossy"}
i = {type = "dielectric", priority = -3}
m = {type = "mirror"}
)");
    ASSERT_EQ(scene.materials.size(), 7U);
    const auto &all = scene.materials;
    EXPECT_EQ(all[0].type, MaterialType::diffuse);
    EXPECT_EQ(all[0].color, glm::dvec3(0, 0.5, 1));
    EXPECT_EQ(all[1].type, MaterialType::dielectric);
    EXPECT_EQ(all[1].ior, 1.33);
    EXPECT_EQ(all[1].absorption, glm::dvec3(0, 0.8, 12));
    EXPECT_EQ(all[2].ior, 1.5);
    EXPECT_EQ(all[2].absorption, glm::dvec3(0));
    EXPECT_EQ(all[2].color, glm::dvec3(1));
    EXPECT_EQ(all[2].priority, 0);
    EXPECT_EQ(all[3].type, MaterialType::glossy);
    EXPECT_EQ(all[3].specularity, 0.25);
    EXPECT_EQ(all[4].specularity, 0.5);
    EXPECT_EQ(all[5].priority, -3);
    EXPECT_EQ(all[6].type, MaterialType::mirror);
}

TEST_F(SceneFile, Lights) {
    const Scene scene = load(R"([[lights]]
type = "point"
position = [0, 3, 3]
color = [1, 0.5, 0]
intensity = 10
range = 5
[[lights]]
type = "point"
position = [0, 0, 0]
[[lights]]
type = "directional"
direction = [-3, -4, 0]
)");
    ASSERT_EQ(scene.lights.size(), 3U);
    const Light &point = scene.lights[0];
    EXPECT_EQ(point.type, LightType::point);
    EXPECT_EQ(point.position, glm::dvec3(0, 3, 3));
    EXPECT_EQ(point.color, glm::dvec3(1, 0.5, 0));
    EXPECT_EQ(point.intensity, 10);
    EXPECT_EQ(point.range, 5);
    EXPECT_EQ(to_string(point.where), at(4, 1));
    EXPECT_EQ(scene.lights[1].color, glm::dvec3(1));
    EXPECT_EQ(scene.lights[1].intensity, 1);
    EXPECT_EQ(scene.lights[1].range, std::numeric_limits<double>::infinity());
    EXPECT_EQ(scene.lights[2].type, LightType::directional);
    expect_near(scene.lights[2].direction, {-0.6, -0.8, 0});
}

TEST_F(SceneFile, DirectionsOfAnyLengthBecomeUnitVectors) {
    const auto normal = [&](const std::string &vector) {
        return load("[[planes]]\npoint = [0, 0, 0]\nnormal = " + vector + "\n").planes.at(0).normal;
    };
    expect_near(normal("[1e18, 1e18, 0]"), {std::sqrt(0.5), std::sqrt(0.5), 0});
    expect_near(normal("[0, -3e-200, 4e-200]"), {0, -0.6, 0.8});
    expect_near(normal("[0, 1e-320, 0]"), {0, 1, 0});
    expect_near(normal("[1e18, 1e-320, 0]"), {1, 0, 0});
}

TEST_F(SceneFile, MeshesWithTheirFileAndMaterial) {
    folder.write("meshes/a.obj", triangle);
    const Scene scene = load(R"([materials.green]
type = "diffuse"
color = [0, 1, 0]
[[meshes]]
file = "meshes/a.obj"
material = "green"
[[meshes]]
file = "meshes/a.obj"
)");
    ASSERT_EQ(scene.meshes.size(), 2U);
    EXPECT_EQ(scene.meshes[0].file, folder.path() / "meshes/a.obj");
    EXPECT_EQ(to_string(scene.meshes[0].where), at(8, 8));
    ASSERT_EQ(scene.triangles.size(), 2U);
    EXPECT_EQ(scene.triangles[0].material, 0);
    EXPECT_EQ(scene.triangles[1].material, 1) << "expected the file's own after the scene's";
}

// Asymmetric in every step, so that no other order of them gives the same.
TEST_F(SceneFile, MeshesAreScaledThenRotatedThenMoved) {
    folder.write("a.obj", triangle);
    const Scene scene = load(R"([[meshes]]
file = "a.obj"
scale = [2, 3, 4]
rotation = [90, 0, 90]
position = [10, 20, 30]
)");
    ASSERT_EQ(scene.triangles.size(), 1U);
    const auto corner = [&](std::size_t i) {
        return scene.vertices[scene.triangles[0].vertices[i]].position;
    };
    EXPECT_LT(glm::distance(corner(0), glm::dvec3(10, 22, 30)), 1e-5);  // x: stays, then to y
    EXPECT_LT(glm::distance(corner(1), glm::dvec3(10, 20, 33)), 1e-5);  // y: to z, stays
    EXPECT_LT(glm::distance(corner(2), glm::dvec3(14, 20, 30)), 1e-5);  // z: to -y, then to x
}

TEST_F(SceneFile, OneScaleCountsForAllAxes) {
    folder.write("a.obj", triangle);
    const Scene scene = load("[[meshes]]\nfile = \"a.obj\"\nscale = 2\n");
    ASSERT_EQ(scene.triangles.size(), 1U);
    const Vertex &second = scene.vertices[scene.triangles[0].vertices[1]];
    EXPECT_LT(glm::distance(second.position, glm::dvec3(0, 2, 0)), 1e-5);
}

TEST_F(SceneFile, TexturesOfUsedMaterialsAreLoadedOnce) {
    folder.write("red.ppm", red_picture);
    const Scene scene = load(R"([materials.a]
type = "diffuse"
texture = "red.ppm"
[materials.b]
type = "mirror"
texture = "./red.ppm"
[materials.c]
type = "glossy"
texture = "not there.png"
[[spheres]]
center = [0, 0, 0]
radius = 1
material = "b"
[[spheres]]
center = [0, 0, 0]
radius = 1
material = "a"
[[spheres]]
center = [0, 0, 0]
radius = 1
material = "a"
)");
    ASSERT_EQ(scene.textures.size(), 1U);
    EXPECT_EQ(scene.textures[0].width, 1);
    EXPECT_EQ(to_string(scene.textures[0].where), at(9, 11));
    EXPECT_EQ(scene.materials.at(0).texture, 0);
    EXPECT_EQ(scene.materials.at(1).texture, 0);
    EXPECT_EQ(scene.materials.at(2).texture, no_texture) << "no shape uses it";
}

TEST_F(SceneFile, TextureOfAMeshsMaterial) {
    folder.write("red.ppm", red_picture);
    folder.write("a.obj", triangle);
    const Scene scene = load(R"([materials.a]
type = "diffuse"
texture = "red.ppm"
[[meshes]]
file = "a.obj"
material = "a"
)");
    EXPECT_EQ(scene.textures.size(), 1U);
    EXPECT_EQ(scene.materials.at(0).texture, 0);
}

// A picture is there once for each way to wrap it.
TEST_F(SceneFile, WrapsAndCutsOut) {
    folder.write("red.ppm", red_picture);
    folder.write("a.obj", triangle);
    const auto material = [](const char *name, const char *more) {
        return fmt::format("[materials.{}]\ntype = \"diffuse\"\ntexture = \"red.ppm\"\n{}\n"
                           "[[meshes]]\nfile = \"a.obj\"\nmaterial = \"{}\"\n",
                           name, more, name);
    };
    const Scene scene =
        load(material("a", "alpha_cutoff = 0.25") + material("b", "wrap = \"clamp\"")
             + material("c", "wrap = [\"mirror\", \"clamp\"]") + material("d", "wrap = \"clamp\""));
    EXPECT_EQ(scene.materials.at(0).alpha_cutoff, 0.25);
    EXPECT_EQ(scene.materials.at(1).alpha_cutoff, 0);
    ASSERT_EQ(scene.textures.size(), 3U);
    const auto wraps = [&](std::size_t number) {
        const Texture &texture = scene.textures.at(std::size_t(scene.materials.at(number).texture));
        return std::pair(texture.wrap_u, texture.wrap_v);
    };
    EXPECT_EQ(wraps(0), std::pair(Wrap::repeat, Wrap::repeat));
    EXPECT_EQ(wraps(1), std::pair(Wrap::clamp, Wrap::clamp));
    EXPECT_EQ(wraps(2), std::pair(Wrap::mirror, Wrap::clamp));
    EXPECT_EQ(wraps(3), wraps(1));
    EXPECT_EQ(scene.textures[0].texels, scene.textures[2].texels);
}

TEST_F(SceneFile, NamesInAnyLanguage) {
    folder.write("böden/schach 市松.ppm", red_picture);
    const Scene scene = load(R"([materials."Glas für 玻璃 🔮"]
type = "diffuse"
texture = "böden/schach 市松.ppm"
[[spheres]]
center = [0, 0, 0]
radius = 1
material = "Glas für 玻璃 🔮"
)");
    EXPECT_EQ(scene.textures.at(0).file.filename(), "schach 市松.ppm");
    EXPECT_EQ(load_scene(folder.write("sz€ne 場.toml", camera)).file.filename(), "sz€ne 場.toml");
}

TEST_F(SceneFile, WindowsLineEndsAndAByteOrderMark) {
    const Scene scene = load_scene(folder.write(
        "a.toml",
        "\xEF\xBB\xBF[camera]\r\nposition = [0, 0, 1]\r\nlook_at = [0, 0, 0]\r\nfov = 45\r\n"));
    EXPECT_EQ(scene.camera.fov, 45);
}

TEST_F(SceneFile, InTheWorkingFolder) {
    folder.write("scene.toml", camera);
    const std::filesystem::path before = std::filesystem::current_path();
    std::filesystem::current_path(folder.path());
    EXPECT_NO_THROW(load_scene("scene.toml"));
    std::filesystem::current_path(before);
}

}  // namespace
}  // namespace stagelight
