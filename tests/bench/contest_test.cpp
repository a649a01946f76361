// SPDX-License-Identifier: MIT
// No figure is told of a tracer that draws another picture.
#include "bench/contest.h"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

namespace stagelight::bench {
namespace {

constexpr int side = 100;
constexpr std::uint64_t rays = 20000;

reference::Result gray() {
    reference::Result truth;
    truth.image = Image(side, side);
    for (glm::vec3 &pixel : truth.image.pixels) {
        pixel = glm::vec3(0.5F);
    }
    truth.edge.resize(truth.image.pixels.size());
    return truth;
}

// Gray, but for the first pixels.
Contestant contestant(const char *name, int pixels_off = 0, float off = 1,
                      std::uint64_t count = rays) {
    return {name, [=] {
                Image image = gray().image;
                for (int i = 0; i < pixels_off; ++i) {
                    image.pixels[static_cast<std::size_t>(i)].g = off;
                }
                return Drawn{image, count, 1};
            }};
}

class Contest : public testing::Test {
protected:
    // What was said.
    static std::string expect_refused(const Contestant &wrong) {
        std::vector<Contestant> contestants{contestant("right"), wrong};
        testing::internal::CaptureStderr();
        EXPECT_FALSE(agree(contestants, gray()));
        return testing::internal::GetCapturedStderr();
    }
    static void expect_taken(const Contestant &right) {
        std::vector<Contestant> contestants{contestant("right"), right};
        EXPECT_TRUE(agree(contestants, gray()));
    }
};

TEST_F(Contest, SamePicturesAgree) {
    expect_taken(contestant("same"));
}

TEST_F(Contest, RoundingMayTurnOnePixelInAThousand) {
    expect_taken(contestant("rounds", 10, 0.504F));
    expect_taken(contestant("rounds", 10, 0.51F));
    EXPECT_EQ(
        expect_refused(contestant("differs", 11, 0.51F)).find("differs draws another picture"), 0U);
}

// Edges have a share of their own.
TEST_F(Contest, EdgesAreJudgedApart) {
    const auto agree_with = [](int edge_pixels, int pixels_off) {
        reference::Result truth = gray();
        std::fill_n(truth.edge.begin(), edge_pixels, std::uint8_t{1});
        std::vector<Contestant> contestants{contestant("right"),
                                            contestant("rounds", pixels_off, 0.51F)};
        testing::internal::CaptureStderr();
        const bool result = agree(contestants, truth);
        testing::internal::GetCapturedStderr();
        return result;
    };
    EXPECT_TRUE(agree_with(10, 20));
    EXPECT_FALSE(agree_with(11, 11));
    EXPECT_FALSE(agree_with(10, 21));
}

// So slightly that no pixel is off by itself.
TEST_F(Contest, BrighterPicturesDisagree) {
    expect_refused(contestant("bright", side * side, 0.501F));
}

TEST_F(Contest, NotANumberDisagrees) {
    expect_refused(contestant("broken", 1, std::numeric_limits<float>::quiet_NaN()));
}

TEST_F(Contest, RaysAreAsMany) {
    expect_taken(contestant("spares a few", 0, 0, rays - 20));
    expect_taken(contestant("does not count", 0, 0, 0));
    const std::string said = expect_refused(contestant("lazy", 0, 0, rays - 21));
    EXPECT_NE(
        said.find("lazy draws another picture than the reference: 19979 rays, expected 20000"),
        std::string::npos)
        << said;
}

TEST_F(Contest, RatioIsTheMedianOfTheRounds) {
    Contestant slow = contestant("slow");
    Contestant fast = contestant("fast");
    fast.milliseconds = {1, 10, 2};
    slow.milliseconds = {3, 20, 8};
    EXPECT_DOUBLE_EQ(ratio_of(slow, fast), 3);
}

}  // namespace
}  // namespace stagelight::bench
