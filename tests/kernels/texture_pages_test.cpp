// SPDX-License-Identifier: MIT
#include "device/texture_pages.h"

#include <gtest/gtest.h>

namespace stagelight {
namespace {

constexpr TextureLimits limits{16384, 16384, 2048};

std::vector<Texture> of_sizes(const std::vector<std::pair<int, int>> &sizes) {
    std::vector<Texture> textures;
    for (const auto &[width, height] : sizes) {
        textures.push_back(
            {.file = {}, .width = width, .height = height, .texels = {}, .where = {}});
    }
    return textures;
}

// Each texture with its border on its layer, and none on another.
void expect_apart(const std::vector<Texture> &textures, const TexturePages &pages) {
    ASSERT_EQ(pages.places.size(), textures.size());
    for (std::size_t i = 0; i < textures.size(); ++i) {
        const TexturePlace &place = pages.places[i];
        EXPECT_LT(place.layer, pages.layers);
        EXPECT_GE(place.x, 1U);
        EXPECT_GE(place.y, 1U);
        EXPECT_LE(place.x + std::size_t(textures[i].width) + 1, pages.width);
        EXPECT_LE(place.y + std::size_t(textures[i].height) + 1, pages.height);
        for (std::size_t j = 0; j < i; ++j) {
            const TexturePlace &other = pages.places[j];
            const auto apart = [](std::size_t a, int size_a, std::size_t b, int size_b) {
                return a + std::size_t(size_a) + 2 <= b || b + std::size_t(size_b) + 2 <= a;
            };
            EXPECT_TRUE(place.layer != other.layer
                        || apart(place.x, textures[i].width, other.x, textures[j].width)
                        || apart(place.y, textures[i].height, other.y, textures[j].height))
                << i << " and " << j;
        }
    }
}

TEST(TexturePages, AreNoneWithoutTextures) {
    EXPECT_EQ(pages_of({}, limits).texels(), 0U);
}

TEST(TexturePages, OfOneTextureAreItsSizeAndABorder) {
    const TexturePages pages = pages_of(of_sizes({{5, 3}}), limits);
    EXPECT_EQ(pages.width, 7U);
    EXPECT_EQ(pages.height, 5U);
    EXPECT_EQ(pages.layers, 1U);
}

// In half precision, as from stage 08 on, 8 bytes a texel.
TEST(TexturePages, SmallOnesLieBesideALargeOne) {
    std::vector<std::pair<int, int>> sizes(20, {64, 64});
    sizes.insert(sizes.begin() + 7, {8192, 4096});
    const std::vector<Texture> textures = of_sizes(sizes);
    const TexturePages pages = pages_of(textures, limits);
    expect_apart(textures, pages);
    EXPECT_LE(pages.texels() * 8, 300'000'000U);
}

TEST(TexturePages, OfManySizesWasteLittle) {
    std::vector<std::pair<int, int>> sizes;
    std::size_t needed = 0;
    for (int i = 0; i < 300; ++i) {
        sizes.emplace_back(1 + i * 37 % 211, 1 + i * 53 % 187);
        needed += std::size_t(sizes.back().first + 2) * std::size_t(sizes.back().second + 2);
    }
    const std::vector<Texture> textures = of_sizes(sizes);
    const TexturePages pages = pages_of(textures, limits);
    expect_apart(textures, pages);
    EXPECT_LT(pages.texels(), needed * 3 / 2);
}

// Of equal size there are as many layers as needed and no more than the device takes.
TEST(TexturePages, KeepToTheLimits) {
    const std::vector<Texture> textures = of_sizes(std::vector(100, std::pair{62, 62}));
    const TexturePages pages = pages_of(textures, {64, 1024, 8});
    expect_apart(textures, pages);
    EXPECT_LE(pages.layers, 8U);
    EXPECT_LE(pages.height, 1024U);
    EXPECT_LE(pages.width, 64U);
}

}  // namespace
}  // namespace stagelight
