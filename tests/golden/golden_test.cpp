// SPDX-License-Identifier: MIT
// Every stage's scenes on two OpenCL implementations that share no compiler: held to the golden
// pictures and to the reference, and the golden pictures to the reference that they are from.
#include <algorithm>
#include <iterator>
#include <string>
#include <tuple>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "golden/suite.h"
#include "image/outliers.h"
#include "implementations.h"
#include "scene/lessons.h"

namespace stagelight::golden {
namespace {

const std::vector<std::string> devices(std::begin(implementations), std::end(implementations));

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

// What rounding may do to a pixel on an edge: show what the reference sees a fiftieth of a pixel
// beside, and nothing else, but for `unseen` pixels.
void expect_rounding_alone(const GoldenScene &scene, const Image &picture, const Image &truth,
                           double tolerance, int unseen) {
    std::vector<glm::ivec2> outliers;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            if (error_of(picture.at(x, y), truth.at(x, y)) > tolerance) {
                outliers.emplace_back(x, y);
            }
        }
    }
    constexpr double reach = 0.02;  // twice the largest shift measured; most are below 0.001
    const auto around = draw_around(scene, outliers, reach);
    std::string found;
    for (std::size_t i = 0; i < outliers.size(); ++i) {
        const glm::vec3 color = picture.at(outliers[i].x, outliers[i].y);
        if (std::ranges::none_of(around[i], [&](const glm::vec3 &seen) {
                return error_of(color, seen) <= tolerance;
            })) {
            found += fmt::format(" ({}, {})", outliers[i].x, outliers[i].y);
            --unseen;
        }
    }
    EXPECT_GE(unseen, 0) << "too many pixels show nothing that the reference sees within " << reach
                         << " pixels:" << found;
}

TEST_P(Golden, DeviceMatchesGolden) {
    const auto &[scene, device] = GetParam();
    const stagelight::Golden golden = read_golden(scene.golden);
    expect_match(draw_device(scene, device), golden.image, golden.edge,
                 tolerance_of(scene.name, device));
}

TEST_P(Golden, DeviceMatchesReference) {
    const auto &[scene, device] = GetParam();
    const reference::Result truth = draw_reference(scene);
    const Image picture = draw_device(scene, device);
    const Tolerance tolerance = tolerance_of(scene.name, device);
    expect_match(picture, truth.image, truth.edge, tolerance);
    if (stage_number(scene.stage) > 1) {
        expect_rounding_alone(scene, picture, truth.image, tolerance.interior,
                              unseen_of(scene.name, device));
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

INSTANTIATE_TEST_SUITE_P(
    Scenes, Golden, testing::Combine(testing::ValuesIn(all_scenes()), testing::ValuesIn(devices)),
    [](const auto &instance) {
        return name_of(std::get<0>(instance.param)) + "_on_" + std::get<1>(instance.param);
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

// However many rays run side by side. On PoCL: rusticl takes minutes to build what is wide.
TEST(Width, Stage10EachMatchesGolden) {
    for (const char *stage : {"09", "10"}) {
        for (const GoldenScene &scene : scenes_of(stage)) {
            const stagelight::Golden golden = read_golden(scene.golden);
            for (const char *width : {"1", "4", "8", "16"}) {
                SCOPED_TRACE(fmt::format("{} at width {}", scene.name, width));
                expect_match(draw_device(scene, "pthread", {{"width", width}}), golden.image,
                             golden.edge, tolerance_of(scene.name, "pthread"));
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
TEST(FresnelExact, Stage10DeviceMatchesReference) {
    expect_method_matches(scenes_of("10").front(), {{"fresnel", "exact"}});
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
