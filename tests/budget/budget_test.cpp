// SPDX-License-Identifier: MIT
// What a budget that float can't meet comes to.
#include <gtest/gtest.h>

#include "budget/budget.h"
#include "device/device_choice.h"
#include "implementations.h"
#include "scene/scene_file.h"

namespace stagelight {
namespace {

Budget between_mirrors(double max_error, const Probes &probes) {
    const Scene scene = load_scene(std::string(STAGELIGHT_SOURCE_DIR) + "/scenes/03_mirrors.toml");
    RenderSettings settings;
    settings.width = 160;
    settings.height = 96;
    settings.max_depth = scene.max_depth;
    return meet_budget(choose_device(implementations.front()), "11_full_tracer", scene, settings,
                       probes, max_error);
}

TEST(Stage11Budget, IsMetInDoubleWhereFloatIsNotEnough) {
    if (!has_extension(choose_device(implementations.front()), "cl_khr_fp64")) {
        GTEST_SKIP() << implementations.front() << " has no doubles";
    }
    Probes probes{.base = {{"fresnel", "exact"}}, .base_error = 1e-7, .probes = {}};
    const Budget in_float = between_mirrors(6e-8, probes);
    EXPECT_FALSE(in_float.is_met);
    EXPECT_GT(in_float.error, 6e-8);
    probes.in_double = Probe{"math", "fp64", 1.5, 1e-8};
    const Budget in_double = between_mirrors(6e-8, probes);
    EXPECT_TRUE(in_double.is_met);
    EXPECT_LT(in_double.error, 6e-8);
    EXPECT_EQ(to_string(in_double.plan, 12), "fresnel=exact, math=fp64");
    EXPECT_EQ(in_double.plan.ratio, 1.5);
    const Budget wide = between_mirrors(1e-3, probes);
    EXPECT_EQ(to_string(wide.plan, 12), "fresnel=exact") << "dearer than it need be";
}

}  // namespace
}  // namespace stagelight
