// SPDX-License-Identifier: MIT
#include "bench/stages.h"

#include <gtest/gtest.h>

namespace stagelight::bench {
namespace {

TEST(BenchStages, SettingsAreTheScenes) {
    Scene scene;
    scene.width = 33;
    scene.height = 21;
    scene.max_depth = 3;
    const RenderSettings settings = settings_of("02_shading_shadows", scene, {{"decode", "2.2"}});
    EXPECT_EQ(settings.width, 33);
    EXPECT_EQ(settings.height, 21);
    EXPECT_EQ(settings.max_depth, 3);
    EXPECT_EQ(settings.methods.at("decode"), "2.2");
    const reference::Result truth = reference_of("02_shading_shadows", scene, settings);
    EXPECT_EQ(truth.image.width, 33);
    EXPECT_EQ(truth.image.height, 21);
}

}  // namespace
}  // namespace stagelight::bench
