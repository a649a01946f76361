// SPDX-License-Identifier: MIT
// Every stage's scenes on two OpenCL implementations: held to the golden pictures, and the golden
// pictures to the reference that they are from.
#include <algorithm>
#include <iterator>
#include <string>
#include <tuple>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "golden/results.h"
#include "golden/spread.h"
#include "golden/suite.h"
#include "image/outliers.h"
#include "implementations.h"
#include "scene/stages.h"

namespace stagelight::golden {
namespace {

const std::vector<std::string> devices(implementations.begin(), implementations.end());

using SceneOnDevice = std::tuple<GoldenScene, std::string>;

std::string name_of(const GoldenScene &scene) {
    return "Stage" + scene.name;
}

class Golden : public testing::TestWithParam<SceneOnDevice> {};
class GoldenPicture : public testing::TestWithParam<GoldenScene> {};

void expect_match(const Image &picture, const Image &truth, const std::vector<std::uint8_t> &edge,
                  const Tolerance &tolerance) {
    const Comparison comparison = compare(picture, truth, edge, tolerance);
    EXPECT_EQ(comparison.failure, "") << to_string(comparison);
    std::cout << to_string(comparison) << '\n';
}

// What rounding may do to a pixel on an edge, and nothing else, but for a few.
void expect_rounding_alone(const GoldenScene &scene, const std::string &device,
                           const Image &picture, const Image &truth) {
    const double tolerance = tolerance_of(scene.name, device).interior;
    const std::vector<glm::ivec2> unseen = unseen_pixels(scene, picture, truth, tolerance);
    std::string found;
    for (const glm::ivec2 &pixel : unseen) {
        found += fmt::format(" ({}, {})", pixel.x, pixel.y);
    }
    EXPECT_LE(double(unseen.size()), bound_of(scene.name, device, "unseen").value)
        << "pixels that show nothing that the reference sees around them:" << found;
}

TEST_P(Golden, DeviceMatchesGolden) {
    const auto &[scene, device] = GetParam();
    const Held held = hold_to_golden(scene, device);
    ASSERT_EQ(held.failure, "") << to_string(held.comparison);
    std::cout << to_string(held.comparison) << '\n';
    if (stage_number(scene.stage) > 1) {
        expect_rounding_alone(scene, device, held.picture, held.golden);
    }
}

// The golden differs from the reference of today by the rounding to half precision alone:
// else it was changed without `golden update`, or the reference was and the golden not.
TEST_P(GoldenPicture, IsTheReferences) {
    const reference::Result truth = draw_reference(GetParam());
    const stagelight::Golden golden = read_golden(GetParam().golden);
    constexpr double half_rounding = 1.0 / 2048;
    expect_match(golden.image, truth.image, std::vector<std::uint8_t>(truth.edge.size(), 0),
                 {.interior = half_rounding, .mean_signed_error = half_rounding});
    EXPECT_EQ(golden.edge, truth.edge);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Golden,
                         testing::Combine(testing::ValuesIn(all_scenes()),
                                          testing::ValuesIn(devices)),
                         [](const auto &instance) {
                             return name_of(std::get<0>(instance.param)) + "_on_"
                                    + name_in_tests(std::get<1>(instance.param));
                         });

INSTANTIATE_TEST_SUITE_P(Scenes, GoldenPicture, testing::ValuesIn(all_scenes()),
                         [](const auto &instance) { return name_of(instance.param); });

// A scene by a method that is not the default.
void expect_method_matches(const GoldenScene &scene, const Methods &methods) {
    SCOPED_TRACE(scene.name);
    const reference::Result truth = draw_reference(scene, methods);
    for (const std::string &device : devices) {
        expect_match(draw_device(scene, device, methods), truth.image, truth.edge,
                     tolerance_of(scene.name, device));
    }
}

TEST(Spread, SaysWhatIsTooLoose) {
    EXPECT_FALSE(is_too_loose("strays", 2, 0)) << "room for another device";
    EXPECT_TRUE(is_too_loose("strays", 3, 0));
    EXPECT_FALSE(is_too_loose("strays", 20, 4));
    EXPECT_TRUE(is_too_loose("strays", 21, 4));
    EXPECT_FALSE(is_too_loose("interior", 0.002, 1e-6)) << "a golden is rounded to half precision";
    EXPECT_TRUE(is_too_loose("interior", 0.003, 1e-6));
    EXPECT_TRUE(is_too_loose("mean_signed_error", 1e-3, 1e-4));
    EXPECT_EQ(proposed_bound("strays", 23), 46);
    EXPECT_NEAR(proposed_bound("interior", 0.00061), 0.0013, 1e-12);
}

// However many rays run side by side. Not on rusticl, which takes minutes to build what is wide.
TEST(Width, Stage11EachMatchesGolden) {
    const std::string &device = devices.front();
    if (is_rusticl(device)) {
        GTEST_SKIP() << "rusticl takes minutes to build what is wide";
    }
    for (const char *stage : {"10", "11"}) {
        for (const GoldenScene &scene : scenes_of(stage)) {
            const stagelight::Golden golden = read_golden(scene.golden);
            for (const char *width : {"1", "4", "8", "16"}) {
                SCOPED_TRACE(fmt::format("{} at width {}", scene.name, width));
                expect_match(draw_device(scene, device, {{"width", width}}), golden.image,
                             golden.edge, tolerance_of(scene.name, device));
            }
        }
    }
}

// The paper's single pass through a sphere, wherever there is glass.
TEST(InteriorPaper, Stage04DeviceMatchesReference) {
    for (const GoldenScene &scene : scenes_of("04")) {
        expect_method_matches(scene, {{"interior", "paper"}});
    }
}

// Fresnel's equations, in the room.
TEST(FresnelExact, Stage11DeviceMatchesReference) {
    expect_method_matches(scenes_of("11").front(), {{"fresnel", "exact"}});
}

// The paper's power for textures, where they fill the picture.
TEST(DecodePower, Stage08DeviceMatchesReference) {
    const std::vector<GoldenScene> scenes = scenes_of("08");
    const auto scene = std::ranges::find(scenes, "08_decode", &GoldenScene::name);
    ASSERT_NE(scene, scenes.end());
    expect_method_matches(*scene, {{"decode", "2.2"}});
}

}  // namespace
}  // namespace stagelight::golden
