// SPDX-License-Identifier: MIT
// --samples N: where in its pixel each sample goes through.
#include <set>

#include <gtest/gtest.h>

#include "device/sample_mean.h"

namespace stagelight {
namespace {

TEST(Stage11Samples, AloneIsThePixelsCentre) {
    const auto [x, y] = sample_point(0, 1).s;
    EXPECT_EQ(x, 0.5F);
    EXPECT_EQ(y, 0.5F);
}

// N samples lie one in each of N columns, and one in each of N rows.
TEST(Stage11Samples, AreOneInEachStratum) {
    for (const int count : {1, 2, 3, 4, 5, 6, 7, 16, 31, 64, 100, 1000, 65536}) {
        std::set<int> columns, rows;
        for (int i = 0; i < count; ++i) {
            const auto [x, y] = sample_point(i, count).s;
            EXPECT_TRUE(x >= 0 && x < 1 && y >= 0 && y < 1) << i << " of " << count;
            columns.insert(int(double{x} * count));
            rows.insert(int(double{y} * count));
        }
        EXPECT_EQ(columns.size(), std::size_t(count)) << count;
        EXPECT_EQ(rows.size(), std::size_t(count)) << count;
    }
}

// Of a power of two, every grid of as many cells has one sample in each, whatever its shape.
TEST(Stage11Samples, FillEveryGridOfPowersOfTwo) {
    constexpr int count = 64;
    for (int across = 1; across <= count; across *= 2) {
        std::set<int> cells;
        for (int i = 0; i < count; ++i) {
            const auto [x, y] = sample_point(i, count).s;
            cells.insert(int(x * float(across)) * count + int(y * float(count / across)));
        }
        EXPECT_EQ(cells.size(), std::size_t(count)) << across << " cells across";
    }
}

}  // namespace
}  // namespace stagelight
