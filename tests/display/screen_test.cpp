// SPDX-License-Identifier: MIT
#include "display/screen.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <random>

#include <glm/common.hpp>

#include "display/open_window.h"
#include "display/shown.h"
#include "image/split.h"

namespace stagelight {
namespace {

constexpr std::array<Transfer, 3> transfers = {Transfer::none, Transfer::srgb, Transfer::power};

class Screen : public OnDisplay {
protected:
    // What the window shows of the picture at scale 1.
    Steps shown(const Image &image, Transfer transfer, const std::optional<double> &split = {}) {
        const PictureTexture texture(image);
        const glm::ivec2 size(image.width, image.height);
        screen.draw(texture.id(), size, window->color_bits(), transfer, split);
        return framebuffer(size, size, window->color_bits());
    }

    stagelight::Screen screen;
};

int byte_of(Transfer transfer, float light) {
    return int(encode(transfer, light) * 255 + 0.5F);
}

// The smallest light that gets that byte, which is above 0. Non-negative floats sort as their bits.
std::uint32_t first_with_byte(Transfer transfer, int byte) {
    std::uint32_t below = std::bit_cast<std::uint32_t>(0.0F);
    std::uint32_t above = std::bit_cast<std::uint32_t>(1.0F);
    while (above - below > 1) {
        const std::uint32_t middle = below + (above - below) / 2;
        (byte_of(transfer, std::bit_cast<float>(middle)) < byte ? below : above) = middle;
    }
    return above;
}

// A row for each byte: the floats around the smallest light that gets it.
Image ties(Transfer transfer) {
    constexpr int reach = 96;
    Image image(2 * reach / 3, 255);
    for (int row = 0; row < 255; ++row) {
        std::uint32_t bits = first_with_byte(transfer, row + 1) - reach;
        for (int column = 0; column < image.width; ++column) {
            for (int channel = 0; channel < 3; ++channel) {
                image.at(column, row)[channel] = std::bit_cast<float>(bits++);
            }
        }
    }
    return image;
}

Image random_picture(int width, int height) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> value(-0.2F, 1.2F);
    Image image(width, height);
    for (glm::vec3 &pixel : image.pixels) {
        pixel = {value(random), value(random), value(random)};
    }
    return image;
}

// `factor` times as large, between pixel centres linearly (OpenGL 4.6, section 8.14.2).
Image enlarged(const Image &image, int factor) {
    Image result(image.width * factor, image.height * factor);
    const auto at = [&](int x, int y) {
        return image.at(std::clamp(x, 0, image.width - 1), std::clamp(y, 0, image.height - 1));
    };
    for (int y = 0; y < result.height; ++y) {
        for (int x = 0; x < result.width; ++x) {
            const float u = (float(x) + 0.5F) / float(factor) - 0.5F;
            const float v = (float(y) + 0.5F) / float(factor) - 0.5F;
            const int left = int(std::floor(u));
            const int top = int(std::floor(v));
            result.at(x, y) =
                glm::mix(glm::mix(at(left, top), at(left + 1, top), u - float(left)),
                         glm::mix(at(left, top + 1), at(left + 1, top + 1), u - float(left)),
                         v - float(top));
        }
    }
    return result;
}

// What a picture should not have, but may.
Image odd_values() {
    using Limits = std::numeric_limits<float>;
    const std::vector<float> values = {Limits::quiet_NaN(),
                                       -Limits::quiet_NaN(),
                                       Limits::infinity(),
                                       -Limits::infinity(),
                                       Limits::max(),
                                       Limits::lowest(),
                                       Limits::min(),
                                       Limits::denorm_min(),
                                       0.0F,
                                       -0.0F,
                                       1.0F,
                                       std::nextafter(1.0F, 2.0F),
                                       -1.0F,
                                       2.0F};
    Image image(int(values.size()), 2);
    for (int x = 0; x < image.width; ++x) {
        image.at(x, 0) = glm::vec3(values[std::size_t(x)]);
        image.at(x, 1) = {0.25F, values[std::size_t(x)], 0.75F};
    }
    return image;
}

// Where two pictures of one size differ, and by how much at most.
struct Difference {
    std::vector<std::pair<int, int>> columns_and_rows;
    int most = 0;
};

Difference difference(const Steps &a, const Steps &b) {
    Difference result;
    for (int i = 0; i < int(a.pixels.size()); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            const int steps = std::abs(a.pixels[std::size_t(i)][c] - b.pixels[std::size_t(i)][c]);
            if (steps > 0) {
                result.columns_and_rows.emplace_back(i % a.width, i / a.width);
                result.most = std::max(result.most, steps);
            }
        }
    }
    return result;
}

TEST_F(Screen, ShowsPixelForPixelWhatThePngHas) {
    for (const auto &[width, height] : {std::pair(640, 384), std::pair(333, 211)}) {
        const Image image = random_picture(width, height);
        EXPECT_EQ(shown(image, Transfer::none), png(image, Transfer::none));
    }
}

TEST_F(Screen, RoundsEveryFloatNearATieAsThePng) {
    const Image image = ties(Transfer::none);
    EXPECT_EQ(shown(image, Transfer::none), png(image, Transfer::none));
}

// The driver's pow is not the C library's. With Mesa's the two bytes differed for the 12 floats
// next to a tie at most: for 7 of the 737,280 values of a random picture.
TEST_F(Screen, EncodesAsThePngButForTheFloatsNextToATie) {
    for (const Transfer transfer : {Transfer::srgb, Transfer::power}) {
        const Image near_ties = ties(transfer);
        const Difference near = difference(shown(near_ties, transfer), png(near_ties, transfer));
        EXPECT_LE(near.most, 1);
        for (const auto &[column, row] : near.columns_and_rows) {
            EXPECT_LE(std::abs(column - near_ties.width / 2), 8) << "tie " << row;
        }
        const Image image = random_picture(640, 384);
        const Difference far = difference(shown(image, transfer), png(image, transfer));
        EXPECT_LE(far.most, 1);
        EXPECT_LE(far.columns_and_rows.size(), 70U);
    }
}

// Where the driver fuses a product and a sum, a tie may fall to the other side.
TEST_F(Screen, EncodesByTheTableAsThePng) {
    const Image image = random_picture(640, 384);
    const Difference found = difference(shown(image, Transfer::table), png(image, Transfer::table));
    EXPECT_LE(found.most, 1);
    EXPECT_LE(found.columns_and_rows.size(), 70U);
    EXPECT_EQ(shown(odd_values(), Transfer::table), png(odd_values(), Transfer::table));
}

TEST_F(Screen, ShowsOddValuesAsThePng) {
    const Image image = odd_values();
    for (const Transfer transfer : transfers) {
        EXPECT_EQ(shown(image, transfer), png(image, transfer));
    }
}

TEST_F(Screen, FillsALargerFramebufferLinearly) {
    const Image image = random_picture(40, 24);
    const PictureTexture texture(image);
    const glm::ivec2 size(640, 384);
    screen.draw(texture.id(), size, window->color_bits(), Transfer::none);
    const Difference found =
        difference(framebuffer(size, size, 8), png(enlarged(image, 16), Transfer::none));
    EXPECT_LE(found.most, 1);
    EXPECT_LE(found.columns_and_rows.size(), 640U * 384U * 3U / 50U);
}

TEST_F(Screen, DividesThePictureAtTheLine) {
    const Image image = random_picture(333, 20);
    const Steps with = shown(image, Transfer::srgb);
    const Steps without = png(image, Transfer::none);
    for (const double share : {0.0, 0.25, 0.5, 1.0}) {
        const Steps divided = shown(image, Transfer::srgb, share);
        const SplitLine line = split_line(share, image.width);
        for (int y = 0; y < image.height; ++y) {
            for (int x = 0; x < image.width; ++x) {
                const std::array<int, 3> on_line = {255, 255, 255};
                ASSERT_EQ(divided.at(x, y), x < line.begin ? with.at(x, y)
                                            : x < line.end ? on_line
                                                           : without.at(x, y))
                    << x << " " << y << ", " << share;
            }
        }
    }
}

TEST(ScreenDeep, RoundsToTheTenBitsOfTheFramebuffer) {
    OpenWindow window({}, 30);
    const stagelight::Screen screen;
    const Image image = random_picture(640, 384);
    const PictureTexture texture(image);
    screen.draw(texture.id(), {640, 384}, window->color_bits(), Transfer::none);
    Steps expected{640, {}};
    for (const glm::vec3 &pixel : image.pixels) {
        std::array<int, 3> &steps = expected.pixels.emplace_back();
        for (int c = 0; c < 3; ++c) {
            steps[std::size_t(c)] = int(encode(Transfer::none, pixel[c]) * 1023 + 0.5F);
        }
    }
    EXPECT_EQ(framebuffer({640, 384}, {640, 384}, 10), expected);
    EXPECT_EQ(window.complaints(), std::vector<std::string>());
}

}  // namespace
}  // namespace stagelight
