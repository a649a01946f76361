// SPDX-License-Identifier: MIT
// The options that change the picture: --size, --out, --samples, --depth, --method.
#include <cmath>

#include <fmt/format.h>

#include "cli/picture_file.h"
#include "cli/program.h"

namespace stagelight::cli {
namespace {

// A ball before a black background. Its blue is above 1/2 wherever it is seen: 0.8 (1/2 + Nz / 2).
constexpr auto ball = R"([camera]
position = [0, 0, 4]
look_at = [0, 0, 0]
fov = 40
[[spheres]]
center = [0, 0, 0]
radius = 1
)";

class Pictures : public Cli {
protected:
    // The stage's picture, in linear float.
    PictureFile draw(const std::string &stage, std::vector<std::string> arguments) const {
        arguments.insert(arguments.end(), {"--out", "picture.exr"});
        const Outcome outcome = run(stage, arguments);
        expect_done(outcome);
        said_ = outcome.out;
        return read_picture_file(folder.path() / "picture.exr");
    }
    const std::string &said() const { return said_; }

private:
    mutable std::string said_;
};

class Stage01Size : public Pictures {};
class Stage01Out : public Pictures {};
class Stage01Samples : public Pictures {};
class Stage03Depth : public Pictures {};
class Stage04Method : public Pictures {};

// One pixel, and sizes that no work-group divides.
TEST_F(Stage01Size, IsThePictures) {
    for (const auto &[width, height] : {std::pair{1, 1}, {17, 5}, {3, 50}}) {
        const PictureFile picture =
            draw("01_primitives", {"--size", fmt::format("{}x{}", width, height)});
        EXPECT_EQ(picture.width, width);
        EXPECT_EQ(picture.height, height);
    }
}

TEST_F(Stage01Size, IsElseTheScenes) {
    folder.write("scene.toml", std::string("[image]\nsize = [33, 21]\n") + ball);
    const PictureFile picture = draw("01_primitives", {"scene.toml"});
    EXPECT_EQ(picture.width, 33);
    EXPECT_EQ(picture.height, 21);
}

// Pictures of odd sizes share the pixel in their middle.
TEST_F(Stage01Size, ChangesTheGridAndNotTheView) {
    const PictureFile one = draw("01_primitives", {"--size", "1x1"});
    const PictureFile nine = draw("01_primitives", {"--size", "9x9"});
    for (int channel = 0; channel < 3; ++channel) {
        EXPECT_NEAR(nine.at(4, 4, channel), one.at(0, 0, channel), 1e-6);
    }
}

// 8 bits a channel in the PNG: the nearest of 256 steps of the same linear value, not encoded.
TEST_F(Stage01Out, PngAndExrHaveTheSamePicture) {
    const PictureFile exr = draw("01_primitives", {"--size", small});
    EXPECT_EQ(exr.format, "float");
    EXPECT_EQ(exr.channels, 3);
    expect_done(run("01_primitives", {"--size", small, "--out", "picture.png"}));
    const PictureFile png = read_picture_file(folder.path() / "picture.png");
    EXPECT_EQ(png.format, "uint8");
    EXPECT_LE(largest_difference(png, exr), 0.5001F / 255);
    EXPECT_GT(largest_difference(png, exr), 0) << "the EXR has 8 bits";
    EXPECT_EQ(files(), (std::vector<std::string>{"picture.exr", "picture.png"}));
}

TEST_F(Stage01Out, ReplacesAnOldPictureWholly) {
    folder.write("picture.png", std::string(1000000, 'x'));
    expect_done(run("01_primitives", {"--size", small, "--out", "picture.png"}));
    EXPECT_EQ(read_picture_file(folder.path() / "picture.png").width, 32);
    EXPECT_LT(std::filesystem::file_size(folder.path() / "picture.png"), 10000);
}

// Off its rim a picture of many samples is that of one where it is flat: the background. On the
// rim, the share of the samples that hit gives it steps in between.
TEST_F(Stage01Samples, SmoothEdgesAndLeaveFlatAreasAlone) {
    folder.write("scene.toml", ball);
    const PictureFile one = draw("01_primitives", {"scene.toml", "--size", small});
    const PictureFile many =
        draw("01_primitives", {"scene.toml", "--size", small, "--samples", "16"});
    int flat = 0;
    int between = 0;
    for (int i = 0; i < 32 * 20; ++i) {
        const float before = one.at(i % 32, i / 32, 2);
        const float after = many.at(i % 32, i / 32, 2);
        flat += before == 0 && after == 0;
        EXPECT_FALSE(before > 0 && before < 0.4F) << before << " is neither ball nor background";
        between += after > 0 && after < 0.4F;
    }
    EXPECT_GT(flat, 200);
    EXPECT_GT(between, 20) << "expected the rim of the ball in steps";
}

// Without bounces mirrors are dark: what they would show is dropped, and said to be.
TEST_F(Stage03Depth, CutsOffReflectionsAndSaysSo) {
    const PictureFile none =
        draw("03_reflection_glossy", {"--size", small, "--depth", "0", "--verbose"});
    expect_part(said(), " rays dropped: deeper than 0 bounces (--depth)\n");
    const PictureFile some = draw("03_reflection_glossy", {"--size", small, "--depth", "8"});
    for (std::size_t i = 0; i < some.values.size(); ++i) {
        EXPECT_LE(none.values.at(i), some.values[i]) << "value " << i;
    }
    EXPECT_GT(largest_difference(none, some), 0.3F);
    EXPECT_EQ(largest_difference(some, draw("03_reflection_glossy", {"--size", small})), 0)
        << "the scene's own depth is 8";
}

TEST_F(Stage04Method, InteriorIsFullOrThePapers) {
    const PictureFile usual = draw("04_refraction_beer", {"--size", small});
    const PictureFile full =
        draw("04_refraction_beer", {"--size", small, "--method", "interior=full"});
    const PictureFile paper =
        draw("04_refraction_beer", {"--size", small, "--method", "interior=paper"});
    EXPECT_EQ(largest_difference(usual, full), 0);
    EXPECT_GT(largest_difference(full, paper), 0.02F);
}

}  // namespace
}  // namespace stagelight::cli
