// SPDX-License-Identifier: MIT
#include "image/compare.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include <gtest/gtest.h>

namespace stagelight {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

// A dark left half beside a bright right one; the edge is the two columns where they meet.
class Compare : public testing::Test {
protected:
    static constexpr int width = 16, height = 8;

    Compare() {
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                truth.at(x, y) = x < 8 ? glm::vec3(0.25F) : glm::vec3(0.5F, 0.75F, 4);
                edge.push_back(x == 7 || x == 8);
            }
        }
        picture = truth;
    }

    Comparison result() const { return compare(picture, truth, edge, tolerance); }

    // One of the failures, and no other.
    void expect_only(const std::string &expected) const {
        const std::string failure = result().failure;
        EXPECT_NE(failure.find(expected), std::string::npos)
            << "expected: " << expected << "\nthe failure: " << failure;
        EXPECT_EQ(failure.find(';'), std::string::npos) << "expected one failure: " << failure;
        EXPECT_EQ(failure.find('\n'), std::string::npos) << "expected one line: " << failure;
    }

    Image picture, truth = Image(width, height);
    std::vector<std::uint8_t> edge;
    Tolerance tolerance = {.interior = 1.0 / 255, .edge_outliers = 2, .mean_signed_error = 1};
};

TEST_F(Compare, TheSamePicture) {
    const Comparison same = result();
    EXPECT_EQ(same.failure, "");
    EXPECT_EQ(same.interior_outliers, 0);
    EXPECT_EQ(same.edge_outliers, 0);
    EXPECT_EQ(same.strays, 0);
    EXPECT_EQ(same.edge_pixels, 2 * height);
    EXPECT_EQ(same.worst_interior, 0);
    EXPECT_EQ(same.mean_signed_error, 0);
    EXPECT_EQ(same.rmse, 0);
    EXPECT_EQ(same.psnr, infinity);
    EXPECT_EQ(same.perceptual_failures, 0);
}

TEST_F(Compare, OneInteriorOutlierFailsAndIsNamed) {
    picture.at(3, 2).g -= 0.0625F;
    picture.at(5, 1).g += 0.03125F;
    const Comparison outliers = result();
    EXPECT_EQ(outliers.interior_outliers, 2);
    EXPECT_EQ(outliers.worst_x, 3);
    EXPECT_EQ(outliers.worst_y, 2);
    EXPECT_EQ(outliers.worst_interior, 0.0625);
    expect_only("2 interior pixels differ by more than 0.00392, worst 0.0625 at (3, 2): "
                "picture (0.25, 0.1875, 0.25), truth (0.25, 0.25, 0.25)");
}

TEST_F(Compare, AnInteriorPixelMayNotMatchItsNeighbourInstead) {
    picture.at(6, 2) = truth.at(8, 2);
    edge.assign(edge.size(), 0);
    picture.at(7, 3) = truth.at(8, 3);
    EXPECT_EQ(result().interior_outliers, 2);
}

TEST_F(Compare, EveryChannelCounts) {
    for (int channel = 0; channel < 3; ++channel) {
        picture = truth;
        picture.at(3, 2)[channel] += 0.005F;
        EXPECT_EQ(result().interior_outliers, 1) << "in channel " << channel;
    }
}

// 1/255 of a dark pixel is absolute, of a bright one relative: 4 / 255 of the blue 4.
TEST_F(Compare, WithinTheToleranceAbsolutelyOrRelatively) {
    picture.at(3, 2) += glm::vec3(0.0039F);
    picture.at(12, 2).b = 4 + 0.0156F;
    EXPECT_EQ(result().failure, "");
    picture.at(3, 2) += glm::vec3(0.0001F);
    EXPECT_EQ(result().interior_outliers, 1) << "expected the absolute bound on a dark pixel";
    picture.at(12, 2).b = 4 - 0.0158F;
    EXPECT_EQ(result().interior_outliers, 2) << "expected the relative bound on a bright pixel";
}

TEST_F(Compare, BlackTruthIsHeldAbsolutely) {
    truth = picture = Image(width, height);
    picture.at(1, 1).r = 0.0039F;
    EXPECT_EQ(result().failure, "");
    picture.at(1, 1).r = 0.004F;
    EXPECT_EQ(result().interior_outliers, 1);
}

TEST_F(Compare, AShiftedEdgeIsCountedAgainstItsBudget) {
    picture.at(7, 2) = truth.at(8, 2);
    picture.at(8, 5) = truth.at(7, 5);
    EXPECT_EQ(result().edge_outliers, 2);
    EXPECT_EQ(result().failure, "");
    picture.at(7, 6) = truth.at(8, 6);
    EXPECT_EQ(result().edge_outliers, 3);
    expect_only("3 edge pixels match only a neighbour (allowed 2), worst 3.75 at (7, 2): "
                "picture (0.5, 0.75, 4), truth (0.25, 0.25, 0.25)");
}

TEST_F(Compare, AnEdgePixelBetweenItsNeighboursIsAStray) {
    picture.at(7, 2) = glm::vec3(0.4F);
    for (const int budget : {0, 1000}) {
        tolerance.edge_outliers = budget;
        EXPECT_EQ(result().strays, 1);
        EXPECT_EQ(result().edge_outliers, 0);
        expect_only(
            "1 edge pixels match no pixel of the 3x3 around (allowed 0), worst 0.15 at (7, 2): "
            "picture (0.4, 0.4, 0.4), truth (0.25, 0.25, 0.25)");
    }
    tolerance.strays = 1;
    EXPECT_EQ(result().failure, "");
}

TEST_F(Compare, OnlyTheThreeByThreeAroundExcuses) {
    const glm::vec3 red(1, 0, 0);
    edge.assign(edge.size(), 1);
    for (int dy = -2; dy <= 2; ++dy) {
        for (int dx = -2; dx <= 2; ++dx) {
            picture = truth = Image(width, height);
            picture.at(7, 4) = red;
            truth.at(7 + dx, 4 + dy) = picture.at(7 + dx, 4 + dy) = red;
            EXPECT_EQ(result().strays, std::abs(dx) == 2 || std::abs(dy) == 2)
                << "with the same colour at " << dx << ", " << dy;
        }
    }
}

TEST_F(Compare, TheSameMistakeNextToItExcusesNothing) {
    picture.at(7, 2) = picture.at(7, 3) = glm::vec3(1, 0, 0);
    EXPECT_EQ(result().strays, 2);
}

TEST_F(Compare, TheBorderHasFewerNeighbours) {
    edge.assign(edge.size(), 1);
    truth.at(width - 1, 3) = picture.at(width - 1, 3) = glm::vec3(1, 0, 0);
    picture.at(0, 4) = glm::vec3(1, 0, 0);
    picture.at(0, 0) = picture.at(width - 1, height - 1) = glm::vec3(0, 1, 0);
    EXPECT_EQ(result().strays, 3) << "the far end of a row is no neighbour";
}

TEST_F(Compare, ADarkeningThatOutliersMissFails) {
    tolerance.mean_signed_error = 1e-4;
    for (glm::vec3 &pixel : picture.pixels) {
        pixel -= glm::vec3(0.0002F);
    }
    EXPECT_EQ(result().interior_outliers, 0);
    EXPECT_NEAR(result().mean_signed_error, -0.0002, 1e-7);
    expect_only("mean signed error -0.0002 (allowed 0.0001)");
}

TEST_F(Compare, ErrorsToBothSidesCancelWithinAChannelOnly) {
    tolerance.mean_signed_error = 1e-4;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        picture.pixels[i] += glm::vec3(i % 2 == 0 ? 0.001F : -0.001F);
    }
    EXPECT_EQ(result().failure, "") << "noise has no mean";
    picture = truth;
    for (glm::vec3 &pixel : picture.pixels) {
        pixel += glm::vec3(0.001F, -0.002F, 0.001F);
    }
    EXPECT_NEAR(result().mean_signed_error, -0.002, 1e-7) << "the largest of the three channels";
    expect_only("mean signed error -0.002");
}

TEST_F(Compare, NamesAllThatFailed) {
    tolerance = {.interior = 1.0 / 255, .edge_outliers = 0, .mean_signed_error = 1e-4};
    picture.at(1, 1) = glm::vec3(1);
    picture.at(7, 2) = truth.at(8, 2);
    picture.at(7, 5) = glm::vec3(0.4F);
    const std::string failure = result().failure;
    for (const char *part : {"1 interior pixels", "(1, 1)", "match only a neighbour", "(7, 2)",
                             "match no pixel", "(7, 5)", "mean signed error"}) {
        EXPECT_NE(failure.find(part), std::string::npos) << part << " not in: " << failure;
    }
}

TEST_F(Compare, NanOrInfinityInEitherFailsAlways) {
    tolerance = {.interior = infinity, .edge_outliers = 1000, .mean_signed_error = infinity};
    const Image finite = truth;
    for (const float value : {nan, infinity, -infinity}) {
        for (const int x : {3, 7}) {
            for (int channel = 0; channel < 3; ++channel) {
                picture.at(x, 2)[channel] = picture.at(15, 7)[channel] = value;
                expect_only("pixel (" + std::to_string(x) + ", 2) of the picture is not finite");
                std::swap(picture, truth);
                expect_only("pixel (" + std::to_string(x) + ", 2) of the truth is not finite");
                picture = truth = finite;
            }
        }
    }
    picture.at(3, 2).r = truth.at(3, 2).r = infinity;
    expect_only("pixel (3, 2) of the picture is not finite");
    EXPECT_TRUE(std::isnan(result().rmse)) << "expected no figure";
}

TEST_F(Compare, AnotherSizeFailsAlways) {
    tolerance = {.interior = infinity, .edge_outliers = 1000, .mean_signed_error = infinity};
    picture = Image(height, width);
    expect_only("the picture is 8x16 pixels, the truth 16x8");
    picture = Image(width, height + 1);
    expect_only("the picture is 16x9 pixels, the truth 16x8");
    picture = Image(width + 1, height);
    expect_only("the picture is 17x8 pixels, the truth 16x8");
    picture = Image();
    expect_only("the picture is 0x0 pixels, the truth 16x8");
    truth = Image();
    edge.clear();
    expect_only("the picture is 0x0 pixels, the truth 0x0");
}

TEST_F(Compare, RmseAndPsnr) {
    for (glm::vec3 &pixel : picture.pixels) {
        pixel.r += 0.1F;
    }
    // Of the three channels one is off by 0.1: sqrt(0.01 / 3), and 10 log10(3 / 0.01) dB.
    EXPECT_NEAR(result().rmse, 0.0577350, 1e-6);
    EXPECT_NEAR(result().psnr, 24.7712, 1e-4);
}

TEST_F(Compare, ThePerceptualCompareSeesARedSquare) {
    truth = Image(64, 64);
    std::fill(truth.pixels.begin(), truth.pixels.end(), glm::vec3(0.5F));
    picture = truth;
    for (int i = 0; i < 100; ++i) {
        picture.at(20 + i % 10, 20 + i / 10) = glm::vec3(1, 0, 0);
    }
    edge.assign(64 * 64, 0);
    EXPECT_EQ(result().perceptual_failures, 100);
}

TEST_F(Compare, PicturesOfAnySize) {
    for (const int w : {1, 2, 3, 5, 31}) {
        for (const int h : {1, 2, 7}) {
            truth = picture = Image(w, h);
            edge.assign(truth.pixels.size(), 1);
            EXPECT_EQ(result().failure, "") << w << "x" << h;
            picture.at(w - 1, h - 1).r = 1;
            EXPECT_EQ(result().strays, 1) << w << "x" << h;
        }
    }
}

TEST_F(Compare, TheFiguresInOneLine) {
    picture.at(3, 2).g -= 0.0625F;
    picture.at(7, 2) = truth.at(8, 2);
    EXPECT_EQ(to_string(result()).substr(0, to_string(result()).find(", RMSE")),
              "1 interior outliers (worst 0.0625 at (3, 2)), 1 edge outliers and 0 strays of 16 "
              "edge pixels, mean signed error 0.0293");
}

}  // namespace
}  // namespace stagelight
