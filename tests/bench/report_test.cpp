// SPDX-License-Identifier: MIT
#include "bench/report.h"

#include <cmath>

#include <gtest/gtest.h>

namespace stagelight::bench {
namespace {

TEST(BenchReport, TableHasNumbersToTheRight) {
    EXPECT_EQ(table({{"", "ms", "rays"}, {"fast", "1.5"}, {"slower", "12.25", "7"}}),
              "           ms  rays\n"
              "fast      1.5\n"
              "slower  12.25     7\n");
}

TEST(BenchReport, ExponentIsThePowerLaws) {
    std::vector<double> x, square_root, constant;
    for (double size = 1000; size < 5e6; size *= 4) {
        x.push_back(size);
        square_root.push_back(3 * std::sqrt(size));
        constant.push_back(8);
    }
    EXPECT_NEAR(fitted_exponent(x, square_root), 0.5, 1e-12);
    EXPECT_NEAR(fitted_exponent(x, constant), 0, 1e-12);
}

TEST(BenchReport, TurnsAreTakenRoundByRound) {
    std::vector<std::size_t> order;
    const auto times = in_turn(2, 3, [&](std::size_t i) {
        order.push_back(i);
        return static_cast<double>(order.size());
    });
    EXPECT_EQ(order, (std::vector<std::size_t>{0, 1, 0, 1, 0, 1}));
    EXPECT_EQ(times, (std::vector<std::vector<double>>{{1, 3, 5}, {2, 4, 6}}));
}

}  // namespace
}  // namespace stagelight::bench
