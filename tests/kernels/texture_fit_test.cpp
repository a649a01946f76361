// SPDX-License-Identifier: MIT
#include "device/texture_fit.h"

#include <gtest/gtest.h>

#include "image/rescale.h"

namespace stagelight {
namespace {

Scene scene_of(int width, int height, const std::vector<std::uint8_t> &texels) {
    Scene scene;
    scene.textures.push_back({.file = "a.png",
                              .width = width,
                              .height = height,
                              .texels = texels,
                              .where = {"scene.toml", 7, 11}});
    return scene;
}

constexpr TextureLimits four{4, 4, 1};  // with a border, 2 texels each way

TEST(TextureFit, LeavesWhatFits) {
    Scene scene = scene_of(2, 1, {1, 2, 3, 4, 5, 6, 7, 8});
    EXPECT_TRUE(fit_textures(scene, four, Transfer::none).empty());
    EXPECT_EQ(scene.textures[0].texels, (std::vector<std::uint8_t>{1, 2, 3, 4, 5, 6, 7, 8}));
}

// Alpha is never decoded. The rows stay in their order.
TEST(TextureFit, TakesTheMeanOfTexels) {
    const std::vector<std::uint8_t> texels{0,  10, 0,  0,  100, 30, 0, 200, 50, 50, 50,
                                           50, 50, 50, 50, 50,  9,  9, 9,   9,  9,  9,
                                           9,  9,  7,  7,  7,   7,  9, 9,   9,  9};
    Scene scene = scene_of(4, 2, texels);
    const auto lines = fit_textures(scene, four, Transfer::none);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_EQ(lines[0],
              "scene.toml:7:11: a.png has 4x2 texels, rescaled to 2x2: this device takes no "
              "larger image");
    EXPECT_EQ(scene.textures[0].width, 2);
    EXPECT_EQ(scene.textures[0].height, 2);
    EXPECT_EQ(scene.textures[0].texels,
              (std::vector<std::uint8_t>{50, 20, 0, 100, 50, 50, 50, 50, 9, 9, 9, 9, 8, 8, 8, 8}));
}

// Half of black and white is half the light, which sRGB's code 188 stands for.
TEST(TextureFit, TakesTheMeanOfLight) {
    Scene scene =
        scene_of(4, 1, {0, 0, 0, 0, 255, 255, 255, 255, 0, 0, 0, 255, 255, 255, 255, 255});
    fit_textures(scene, four, Transfer::srgb);
    EXPECT_EQ(scene.textures[0].texels,
              (std::vector<std::uint8_t>{188, 188, 188, 128, 188, 188, 188, 255}));
}

TEST(TextureFit, LeavesADeviceWithoutImagesAlone) {
    Scene scene = scene_of(1, 1, {1, 2, 3, 4});
    EXPECT_TRUE(fit_textures(scene, {0, 0, 0}, Transfer::none).empty());
}

// From 3 to 2 pixels, each has one and a half.
TEST(Rescale, WeighsPixelsByWhatIsCovered) {
    const FloatPicture picture{3, 1, {glm::vec4(0), glm::vec4(3), glm::vec4(6)}};
    const FloatPicture smaller = rescale(picture, 2, 1);
    ASSERT_EQ(smaller.pixels.size(), 2U);
    EXPECT_NEAR(smaller.pixels[0].x, 1, 1e-6);
    EXPECT_NEAR(smaller.pixels[1].w, 5, 1e-6);
}

}  // namespace
}  // namespace stagelight
