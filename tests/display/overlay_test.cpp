// SPDX-License-Identifier: MIT
#include "display/overlay.h"

#include <algorithm>

#include "display/gl.h"
#include "display/input.h"
#include "display/open_window.h"
#include "display/screen.h"
#include "display/shown.h"

namespace stagelight {
namespace {

using Lines = std::vector<std::string>;

constexpr std::array<int, 3> picture = {128, 128, 128};
constexpr std::array<int, 3> panel = {32, 32, 32};
constexpr std::array<int, 3> ink = {255, 255, 255};

class Overlay : public OnDisplay {
protected:
    Steps shown(const Lines &lines, const glm::ivec2 &size, float content_scale = 1) {
        Image grey(1, 1);
        grey.pixels = {glm::vec3(128.0F / 255)};
        const PictureTexture texture(grey);
        screen.draw(texture.id(), size, window->color_bits(), Transfer::none);
        overlay.draw(lines, size, content_scale);
        return framebuffer(size, size, window->color_bits());
    }

    Screen screen;
    stagelight::Overlay overlay;
};

// What is in a column of a text that is shown one pixel for each unit of the font.
Lines cell(const Steps &steps, int column, int row = 0) {
    Lines rows;
    for (int y = 12 + 12 * row; y < 24 + 12 * row; ++y) {
        std::string &line = rows.emplace_back();
        for (int x = 12 + 7 * column; x < 19 + 7 * column; ++x) {
            line += steps.at(x, y) == ink ? '#' : steps.at(x, y) == panel ? '.' : '!';
        }
    }
    return rows;
}

Steps doubled(const Steps &steps) {
    Steps result{2 * steps.width, {}};
    const int height = int(steps.pixels.size()) / steps.width;
    for (int y = 0; y < 2 * height; ++y) {
        for (int x = 0; x < result.width; ++x) {
            result.pixels.push_back(steps.at(x / 2, y / 2));
        }
    }
    return result;
}

TEST_F(Overlay, ShowsALetterInItsColumn) {
    EXPECT_EQ(cell(shown({"oL"}, {64, 48}), 1),
              Lines({"#......", "#......", "#......", "#......", "#......", "#......", "####...",
                     ".......", ".......", ".......", ".......", "......."}));
}

TEST_F(Overlay, EveryCharacterHasInk) {
    std::string all;
    for (char c = '!'; c <= '~'; ++c) {
        all += c;
    }
    const Steps steps = shown({all.substr(0, 50), all.substr(50)}, {400, 100});
    for (int i = 0; i < int(all.size()); ++i) {
        const Lines letter = cell(steps, i % 50, i / 50);
        EXPECT_TRUE(std::any_of(letter.begin(), letter.end(), [](const std::string &row) {
            return row.find('#') != std::string::npos;
        })) << all[std::size_t(i)];
    }
}

TEST_F(Overlay, StandsInColumns) {
    const glm::ivec2 size(100, 48);
    EXPECT_EQ(cell(shown({"....W"}, size), 4), cell(shown({"WWWWW"}, size), 4));
    EXPECT_EQ(cell(shown({"x", "...^"}, size), 3, 1), cell(shown({"x", "   ^"}, size), 3, 1));
}

TEST_F(Overlay, TabsAndWhatTheFontLacks) {
    const glm::ivec2 size(100, 48);
    EXPECT_EQ(shown({"a\tb"}, size), shown({"a   b"}, size));
    EXPECT_EQ(shown({"a\xe2\x80\x98\x01\x7f"}, size), shown({"a???"}, size));
}

TEST_F(Overlay, TheKeysAreLegibleAtTheUsualSize) {
    const Steps small = shown(key_help(), {320, 192});
    EXPECT_EQ(small.at(319, 100), picture) << "it fits";
    EXPECT_EQ(small.at(12, 191), picture) << "it fits";
    EXPECT_EQ(shown(key_help(), {640, 384}), doubled(small));
    EXPECT_EQ(shown(key_help(), {640, 384}, 2), doubled(small));
}

TEST_F(Overlay, ATextThatIsTooLargeIsCut) {
    const glm::ivec2 size(64, 48);
    const Steps steps = shown(Lines(100, std::string(200, 'a')), size);
    EXPECT_EQ(steps, shown(Lines(2, std::string(5, 'a')), size));
    EXPECT_EQ(steps.at(63, 20), picture);
    EXPECT_EQ(steps.at(20, 47), picture);
}

TEST_F(Overlay, LettersStayLargeOnAFineScreen) {
    const Lines text = {std::string(100, 'a')};
    EXPECT_EQ(shown(text, {640, 384}, 2), doubled(shown(text, {320, 192}, 1)));
}

TEST_F(Overlay, TheSmallestWindowIsNoMatter) {
    for (const glm::ivec2 size : {glm::ivec2(1, 1), glm::ivec2(20, 384), glm::ivec2(640, 20)}) {
        shown({"text", "", "text"}, size);
    }
    shown({}, {64, 48});
}

TEST_F(Overlay, LeavesThePictureBesideItAndBlendingAsTheyWere) {
    const Steps steps = shown({"text"}, {640, 384});
    for (int y = 0; y < 384; ++y) {
        for (int x = 0; x < 640; ++x) {
            // Two pixels a unit of the font: a margin of 6 units, 4 columns, one row, their
            // margins.
            const bool inside = x >= 12 && x < 12 + 2 * (28 + 12) && y >= 12 && y < 12 + 2 * 24;
            ASSERT_EQ(steps.at(x, y) != picture, inside) << x << " " << y;
        }
    }
    EXPECT_FALSE(glIsEnabled(GL_BLEND));
}

}  // namespace
}  // namespace stagelight
