// SPDX-License-Identifier: MIT
// Stage 11: how deep rays go, and what is lost with those that are cut off.
#include "render/on_each_device.h"
#include "scene/radiance_bound.h"
#include "scene/scene_file.h"

namespace stagelight::render {
namespace {

class Stage11ImportanceCutoff : public OnEachDevice {};
INSTANTIATE_TEST_SUITE_P(Devices, Stage11ImportanceCutoff, each_device(), device_name);

constexpr auto stage = "11_full_tracer";

// Between mirrors that face each other a ray keeps half of its weight at each bounce: after the
// twelfth it has 1/4096, and is still traced; the thirteenth is not.
TEST_P(Stage11ImportanceCutoff, EndsTheRayBelowOnePartIn4096) {
    Scene scene = one_pixel({0, 0, 0}, {0, 0, -1});
    scene.max_depth = 64;
    add_plane(scene, {0, 0, 1}, {0, 0, -1}, mirror({0.5, 0.3, 0.1}));
    add_plane(scene, {0, 0, 1}, {0, 0, 1}, mirror({0.5, 0.3, 0.1}));
    const RayTotals rays = draw(stage, scene).rays;
    EXPECT_EQ(rays.reflection, 12u);
    EXPECT_EQ(rays.cut_off, 1u);
    EXPECT_EQ(rays.dropped, 0u);
    EXPECT_DOUBLE_EQ(rays.cut_off_weight, 1.0 / 8192);
    EXPECT_EQ(draw("10_packets", scene).rays.cut_off, 0u);
}

// Stage 10 traces what stage 11 leaves out; light ends on meshes as there.
TEST_P(Stage11ImportanceCutoff, StaysWithinItsBound) {
    for (const char *name : {"03_reflection_glossy", "04_interior", "07_interop"}) {
        Scene scene = load_scene(std::string(STAGELIGHT_SOURCE_DIR) + "/scenes/" + name + ".toml");
        scene.width = 80;
        scene.height = 48;
        RenderSettings settings = settings_of(scene);
        settings.methods = {{"decode", "2.2"}, {"terminator", "none"}};
        const Frame whole = renderer("10_packets", scene, settings).render();
        const Frame cut = renderer(stage, scene, settings).render();
        const double bound = cut.rays.cut_off_weight * radiance_bound(scene);
        double worst = 0;
        for (std::size_t i = 0; i < whole.image.pixels.size(); ++i) {
            const dvec3 off(whole.image.pixels[i] - cut.image.pixels[i]);
            worst = std::max({worst, std::abs(off.x), std::abs(off.y), std::abs(off.z)});
        }
        EXPECT_GT(cut.rays.cut_off, 0u) << name;
        EXPECT_GT(worst, 0) << name;
        EXPECT_LE(worst, bound + few_roundings) << name;
        EXPECT_LT(worst, 0.25 / 255) << name;
        EXPECT_LT(cut.rays.traced(), whole.rays.traced()) << name;
    }
}

Scene of(const Material &material) {
    Scene scene;
    add_sphere(scene, {0, 0, 0}, 1, diffuse({1, 1, 1}));
    add_sphere(scene, {3, 0, 0}, 1, material);
    return scene;
}

// The largest n for which share^n is 1/4096 or more.
TEST(Stage11Depth, IsWhatTheMaterialsNeed) {
    EXPECT_EQ(depth_of(Scene{}, 11), 0);
    EXPECT_EQ(depth_of(of(diffuse({1, 1, 1})), 11), 0);
    EXPECT_EQ(depth_of(of(glossy({1, 1, 1}, 0)), 11), 0);
    EXPECT_EQ(depth_of(of(glossy({1, 0.5, 0.5}, 0.5)), 11), 12);
    EXPECT_EQ(depth_of(of(glossy({0.5, 0.1, 0.3}, 0.5)), 11), 6);
    EXPECT_EQ(depth_of(of(mirror({0.1, 0.125, 0.1})), 11), 4);
    EXPECT_EQ(depth_of(of(glass({0.25, 0, 0}, 1.5, {})), 11), 6);
    EXPECT_EQ(depth_of(of(mirror({0, 0, 0.8})), 11), 16) << "37, but no more than 16";
    EXPECT_EQ(depth_of(of(glass({1, 0, 0}, 1.5, {})), 11), 8) << "they bound nothing";
    Scene unused = of(diffuse({1, 1, 1}));
    add_material(unused, mirror({1, 1, 1}));
    EXPECT_EQ(depth_of(unused, 11), 0);
}

TEST(Stage11Depth, IsElseTheFiles) {
    Scene scene = of(glossy({0.5, 0.1, 0.3}, 0.5));
    EXPECT_EQ(depth_of(scene, 10), 8);
    scene.max_depth = 40;
    scene.has_max_depth = true;
    EXPECT_EQ(depth_of(scene, 10), 40);
    EXPECT_EQ(depth_of(scene, 11), 40);
}

}  // namespace
}  // namespace stagelight::render
