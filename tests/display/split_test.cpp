// SPDX-License-Identifier: MIT
#include "image/split.h"

#include <gtest/gtest.h>

namespace stagelight {
namespace {

TEST(SplitLine, LiesInThePictureAtItsShare) {
    for (const int width : {1, 2, 100, 333, 640, 1280}) {
        for (const double share : {0.0, 0.3, 0.5, 1.0}) {
            const SplitLine line = split_line(share, width);
            EXPECT_GE(line.begin, 0);
            EXPECT_LT(line.begin, line.end);
            EXPECT_LE(line.end, width);
            EXPECT_NEAR((line.begin + line.end) / 2.0, share * width, width / 640.0 + 1);
        }
        EXPECT_EQ(split_line(0, width).begin, 0);
        EXPECT_EQ(split_line(1, width).end, width);
    }
}

}  // namespace
}  // namespace stagelight
