// SPDX-License-Identifier: MIT
// Which methods a budget buys, by probes that were made up.
#include <cmath>

#include <gtest/gtest.h>

#include "budget/budget.h"
#include "budget/truth.h"

namespace stagelight {
namespace {

const Probes probes{
    .base = {{"fresnel", "exact"}},
    .base_error = 1e-5,
    .probes = {{"fresnel", "schlick", 0.9, 1e-3},
               {"fresnel", "none", 0.5, 1e-2},
               {"math", "relaxed", 1.2, 1e-6},  // slower
               {"math", "mad", 0.99, 1e-6},     // too little to be measured
               {"sphere", "textbook", 0.8, 3e-3},
               {"sphere", "geometric", 0.7, 1e-4},  // better in both
               {"limit", "2", 0.6, 5e-3}},
};

Plan plan_for(double limit) {
    return cheapest_plan(probes, 8, limit);
}

TEST(Stage11Plan, OfNothingIsTheBase) {
    const Plan plan = plan_for(1e-6);
    EXPECT_EQ(plan.methods, probes.base);
    EXPECT_EQ(plan.max_depth, 8);
    EXPECT_EQ(plan.ratio, 1);
    EXPECT_DOUBLE_EQ(plan.error, 1e-5);
    EXPECT_EQ(to_string(plan, 8), "fresnel=exact");
}

TEST(Stage11Plan, TakesWhatIsFasterAndWithinTheLimit) {
    const Plan plan = plan_for(2e-4);
    EXPECT_EQ(to_string(plan, 8), "fresnel=exact, sphere=geometric");
    EXPECT_DOUBLE_EQ(plan.ratio, 0.7);
    EXPECT_DOUBLE_EQ(plan.error, std::hypot(1e-5, 1e-4));
}

// The squares of both errors together are over the limit: the faster of the two is taken.
TEST(Stage11Plan, WeighsChoicesAgainstEachOther) {
    EXPECT_EQ(to_string(plan_for(1.05e-2), 8), "fresnel=none, sphere=geometric");
    const Plan both = plan_for(1.2e-2);
    EXPECT_EQ(to_string(both, 8), "fresnel=none, sphere=geometric, depth limit=2");
    EXPECT_EQ(both.max_depth, 2);
    EXPECT_DOUBLE_EQ(both.ratio, 0.5 * 0.7 * 0.6);
}

TEST(Stage11Plan, IsNeverSlowerForMoreError) {
    double before = 1;
    for (double limit = 1e-6; limit < 1; limit *= 1.2) {
        const Plan plan = plan_for(limit);
        EXPECT_LE(plan.ratio, before) << limit;
        EXPECT_TRUE(plan.error <= limit || plan.ratio == 1) << limit;
        before = plan.ratio;
    }
}

TEST(Stage11Rmse, IsOverAllPixelsAndChannels) {
    Image truth(2, 1);
    Image picture = truth;
    EXPECT_EQ(rmse_of(picture, truth), 0);
    picture.at(1, 0) = {0, 0.6F, 0};
    EXPECT_NEAR(rmse_of(picture, truth), 0.6 / std::sqrt(6), 1e-7);
    picture.at(0, 0).x = NAN;
    EXPECT_EQ(rmse_of(picture, truth), INFINITY);
}

}  // namespace
}  // namespace stagelight
