// SPDX-License-Identifier: MIT
// The same scene a thousand times smaller or larger, or far from the origin, is the same picture.
#include "image/compare.h"
#include "reference/reference.h"
#include "render/moved.h"
#include "render/on_each_device.h"
#include "scene/scene_file.h"

namespace stagelight::render {
namespace {

class OfAnySize : public OnEachDevice {
protected:
    static void expect_same_pictures(const char *stage) {
        Scene scene = load_scene(std::string(STAGELIGHT_SOURCE_DIR) + "/scenes/" + stage + ".toml");
        scene.width = 96;
        scene.height = 58;
        const auto edge =
            reference::render<double>(scene, {scene.width, scene.height, scene.max_depth, {}}).edge;
        const Image picture = draw(stage, scene).image;
        const auto with = [&](const Scene &other) {
            return compare(draw(stage, other).image, picture, edge, {});
        };
        for (const double scale : {0.001, 1000.0}) {
            const Comparison comparison = with(scaled(scene, scale));
            EXPECT_EQ(comparison.failure, "") << scale << ": " << to_string(comparison);
        }
        // There a float is 2^-17 of a unit from the next: an edge may fall on its other side.
        const Comparison far = with(shifted(scene, {100, 50, -80}));
        EXPECT_EQ(far.interior_outliers, 0) << to_string(far);
        EXPECT_LE(far.edge_outliers + far.strays, 96 * 58 / 200) << to_string(far);
        EXPECT_LE(std::abs(far.mean_signed_error), Tolerance{}.mean_signed_error);
    }
};

class Stage04Scale : public OfAnySize {};
class Stage05Scale : public OfAnySize {};
INSTANTIATE_TEST_SUITE_P(Devices, Stage04Scale, each_device(), device_name);
INSTANTIATE_TEST_SUITE_P(Devices, Stage05Scale, each_device(), device_name);

TEST_P(Stage04Scale, LeavesGlassAndMirrorsAsTheyAre) {
    expect_same_pictures("04_refraction_beer");
}

TEST_P(Stage05Scale, LeavesSuzanneAndHerShadowAsTheyAre) {
    expect_same_pictures("05_meshes");
}

}  // namespace
}  // namespace stagelight::render
