// SPDX-License-Identifier: MIT
// Model no more than a scene needs: what a kernel is handed, by name and size, and nothing else.
#include <algorithm>
#include <set>

#include "device/bvh.h"
#include "device/texture_pages.h"
#include "render/on_each_device.h"
#include "scene/scene_file.h"
#include "scene/stages.h"

namespace stagelight::render {
namespace {

using Names = std::set<std::string>;
using Sizes = std::map<std::string, std::size_t>;

Names operator+(Names names, const Names &more) {
    names.insert(more.begin(), more.end());
    return names;
}

// What every kernel has, and what comes with a scene's parts.
const Names picture{"image", "camera", "background"};
const Names shaded{"image", "camera", "background", "ray_counts", "materials"};
const Names mesh{"triangles", "triangle_corners", "vertex_normals"};
const Names tree{"triangles", "triangle_corners", "vertex_normals", "bvh_nodes"};
// In the arguments themselves: no buffer.
const Names values{"camera",      "background",  "sphere_count",
                   "plane_count", "light_count", "triangle_count"};

// Beside each buffer, the argument that says how many are in it.
Names with_counts(Names names) {
    for (const auto &[buffer, count] :
         std::map<std::string, std::string>{{"spheres", "sphere_count"},
                                            {"planes", "plane_count"},
                                            {"lights", "light_count"},
                                            {"triangles", "triangle_count"}}) {
        if (names.contains(buffer)) {
            names.insert(count);
        }
    }
    return names;
}

Names arguments(const Renderer &renderer) {
    const std::vector<std::string> names = argument_names(renderer.stage_kernel().kernel());
    const Names set(names.begin(), names.end());
    EXPECT_EQ(set.size(), names.size());
    return set;
}

// Each part that is there, at the size of its struct in kernels/scene_types.h.
Sizes sizes_of(const Scene &scene, const Names &parts, std::size_t texel) {
    const std::size_t vertices = scene.vertices.size();
    Sizes sizes{{"image", std::size_t(scene.width) * std::size_t(scene.height) * 16},
                {"ray_counts", std::size_t(scene.height) * 24},
                {"spheres", scene.spheres.size() * 32},
                {"planes", scene.planes.size() * 32},
                {"materials", scene.materials.size() * 64},
                {"lights", scene.lights.size() * 64},
                {"triangles", scene.triangles.size() * 16},
                {"triangle_corners", scene.triangles.size() * 48},
                {"bvh_nodes", build_bvh(scene).nodes.size() * 128},
                {"vertex_normals", vertices * 16},
                {"vertex_texture_coordinates", vertices * 8},
                {"vertex_colors", vertices * 16},
                {"cutouts", scene.materials.size() * 8},
                {"alphas", 2},
                {"textures", pages_of(scene.textures, {16384, 16384, 2048}).texels() * texel}};
    std::erase_if(sizes, [&](const auto &size) { return !parts.contains(size.first); });
    return sizes;
}

// A texel has four bytes, and from stage 08 on four halves.
void expect_arguments(const Renderer &renderer, const Scene &scene, const Names &parts,
                      std::size_t texel = 4) {
    const Names expected = with_counts(parts);
    EXPECT_EQ(arguments(renderer), expected);
    EXPECT_EQ(renderer.bytes(), sizes_of(scene, expected, texel));
    for (const std::string &name : expected) {
        EXPECT_NE(renderer.bytes().contains(name), values.contains(name)) << name;
    }
}

struct DefaultScene {
    std::string stage;
    Names expected;
};

void PrintTo(const DefaultScene &scene, std::ostream *stream) {
    *stream << scene.stage;
}

class Arguments : public testing::TestWithParam<std::tuple<DefaultScene, const char *>> {};

TEST_P(Arguments, AreWhatTheDefaultSceneNeeds) {
    const auto &[wanted, device] = GetParam();
    const std::string file =
        std::string(STAGELIGHT_SOURCE_DIR) + "/scenes/" + wanted.stage + ".toml";
    Scene scene = load_scene(file);
    scene.width = 33;
    scene.height = 9;
    const Renderer renderer(choose_device(device), wanted.stage, scene, settings_of(scene));
    expect_arguments(renderer, scene, wanted.expected,
                     stage_number(wanted.stage) >= gamma_stage ? 8 : 4);
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, Arguments,
    testing::Combine(
        testing::Values(
            DefaultScene{"01_primitives", picture + Names{"spheres", "planes"}},
            DefaultScene{"02_shading_shadows", shaded + Names{"spheres", "planes", "lights"}},
            DefaultScene{"03_reflection_glossy", shaded + Names{"spheres", "planes", "lights"}},
            DefaultScene{"04_refraction_beer", shaded + Names{"spheres", "planes", "lights"}},
            DefaultScene{"05_meshes", shaded + mesh + Names{"planes", "lights"}},
            DefaultScene{"06_textures", shaded + mesh
                                            + Names{"spheres", "planes", "lights", "textures",
                                                    "vertex_texture_coordinates"}},
            DefaultScene{"07_interop", shaded + mesh
                                           + Names{"spheres", "planes", "lights", "textures",
                                                   "vertex_texture_coordinates"}},
            DefaultScene{"08_gamma", shaded + mesh
                                         + Names{"spheres", "planes", "lights", "textures",
                                                 "vertex_texture_coordinates"}},
            DefaultScene{"09_tree", shaded + tree + Names{"spheres", "planes", "lights"}},
            DefaultScene{"10_packets", shaded + tree + Names{"spheres", "planes", "lights"}},
            DefaultScene{"11_full_tracer", shaded + tree
                                               + Names{"spheres", "planes", "lights", "textures",
                                                       "vertex_texture_coordinates"}}),
        each_device()),
    [](const auto &scene) {
        return "Stage" + std::get<0>(scene.param).stage + "_"
               + name_in_tests(std::get<1>(scene.param));
    });

class Stage06Arguments : public OnEachDevice {
protected:
    static void expect(const Scene &scene, const Names &expected) {
        const Renderer renderer = OnEachDevice::renderer("06_textures", scene);
        expect_arguments(renderer, scene, expected);
    }
};
INSTANTIATE_TEST_SUITE_P(Devices, Stage06Arguments, each_device(), device_name);

int add_textured(Scene &scene) {
    scene.textures.push_back(texture_of(2, 1, {255, 0, 0, 255, 0, 255, 0, 255}));
    Material material = diffuse({1, 1, 1});
    material.texture = 0;
    return add_material(scene, material);
}

// The mesh has no picture: no coordinates.
TEST_P(Stage06Arguments, OfATexturedSphereBesideAPlainMesh) {
    Scene scene = one_pixel({0, 0, 3}, {0, 0, 0});
    scene.spheres.push_back({.material = add_textured(scene), .where = {}});
    scene.textures.push_back(texture_of(1, 3, std::vector<std::uint8_t>(12)));
    add_flat_triangle(scene, {0, 0, 0}, {1, 0, 0}, {0, 1, 0},
                      add_material(scene, diffuse({1, 1, 1})));
    expect(scene, shaded + mesh + Names{"spheres", "textures"});
}

TEST_P(Stage06Arguments, OfATexturedMeshAlone) {
    Scene scene = one_pixel({0, 0, 3}, {0, 0, 0});
    add_flat_triangle(scene, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, add_textured(scene));
    expect(scene, shaded + mesh + Names{"vertex_texture_coordinates", "textures"});
}

TEST_P(Stage06Arguments, OfAMeshThatIsCutOut) {
    Scene scene = one_pixel({0, 0, 3}, {0, 0, 0});
    add_flat_triangle(scene, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, add_textured(scene));
    scene.materials[0].alpha_cutoff = 0.5;
    expect(scene,
           shaded + mesh + Names{"vertex_texture_coordinates", "textures", "cutouts", "alphas"});
}

TEST_P(Stage06Arguments, OfAMeshWithColorsOfVertices) {
    Scene scene = one_pixel({0, 0, 3}, {0, 0, 0});
    add_flat_triangle(scene, {0, 0, 0}, {1, 0, 0}, {0, 1, 0},
                      add_material(scene, diffuse({1, 1, 1})));
    scene.vertices[1].color = {1, 0.5, 1};
    expect(scene, shaded + mesh + Names{"vertex_colors"});
}

// Nothing is diffuse, so the light that there is lights nothing.
TEST_P(Stage06Arguments, OfAMirrorUnderALight) {
    Scene scene = one_pixel({0, 0, 3}, {0, 0, 0});
    add_sphere(scene, {0, 0, 0}, 1, mirror({1, 1, 1}));
    add_point_light(scene, {0, 3, 0}, {1, 1, 1}, 1);
    expect(scene, shaded + Names{"spheres"});
}

// Every stage draws what the earlier ones do: a scene that has nothing new in it.
class Earlier : public testing::TestWithParam<std::tuple<std::string, const char *>> {};

TEST_P(Earlier, ScenesAreDrawnWithoutWhatTheyHaveNot) {
    const auto &[stage, device] = GetParam();
    const auto draw = [&](const Scene &scene) {
        return Renderer(choose_device(device), stage, scene, settings_of(scene)).render().image;
    };
    const bool shades = stage_number(stage) > 1;
    Scene plain = one_pixel({0, 0, 3}, {0, 0, 0});
    add_sphere(plain, {0, 0, 0}, 1, diffuse({1, 1, 1}));
    if (shades) {
        expect_color(draw(plain), 0, 0, dvec3(0));  // no light
    }
    add_point_light(plain, {0, 0, 3}, {1, 1, 1}, 2);
    expect_color(draw(plain), 0, 0, shades ? dvec3(0.5) : dvec3(0.5, 0.5, 1));
    plain.spheres.clear();
    plain.lights.clear();
    add_plane(plain, {0, 0, 1}, {0, 0, 1}, diffuse({1, 1, 1}));
    add_directional_light(plain, {0, 0, -1}, {1, 1, 1}, 0.5);
    expect_color(draw(plain), 0, 0, shades ? dvec3(0.5) : dvec3(0.5, 0.5, 1));
}

INSTANTIATE_TEST_SUITE_P(Stages, Earlier,
                         testing::Combine(testing::ValuesIn(stage_names()), each_device()),
                         [](const auto &scene) {
                             return "Stage" + std::get<0>(scene.param) + "_"
                                    + name_in_tests(std::get<1>(scene.param));
                         });

int need(const Scene &scene, const std::string &name) {
    return value_of(needs_of(scene, 4, scene.max_depth), name);
}

// One place where each ray spawns one at most. Where it may split in two, of the two at depth d one
// waits while the other is traced: after the last split at depth D - 1 there wait one of each depth
// 1 … D - 1 and two of depth D, which are D + 1. (Under oclgrind a stack too small is seen: its
// test draws the scene of stage 04, in which total reflection goes on to the depth limit.)
TEST(Stage04Stack, IsAsDeepAsRaysCanSplit) {
    Scene scene;
    scene.max_depth = 7;
    add_sphere(scene, {0, 0, 0}, 1, glossy({1, 1, 1}, 0.5));
    EXPECT_EQ(need(scene, "STACK_SIZE"), 1);
    add_material(scene, glass({1, 1, 1}, 1.5, {}));  // of no shape
    EXPECT_EQ(need(scene, "STACK_SIZE"), 1);
    EXPECT_EQ(need(scene, "HAS_DIELECTRIC"), 0);
    add_sphere(scene, {0, 0, 0}, 1, glass({1, 1, 1}, 1.5, {}));
    EXPECT_EQ(need(scene, "STACK_SIZE"), 8);
    EXPECT_EQ(need(scene, "HAS_DIELECTRIC"), 1);
}

}  // namespace
}  // namespace stagelight::render
