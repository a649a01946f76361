// SPDX-License-Identifier: MIT
// Gamma is done once, from the texture's file to the picture's: a square that faces eye and light
// shows its picture, a texel in each pixel, so that the light that leaves is the texel's.
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "cli/picture_file.h"
#include "cli/program.h"
#include "exact_curves.h"
#include "image/image_io.h"

namespace stagelight::cli {
namespace {

constexpr auto square = R"(v -1 -1 0
v 1 -1 0
v 1 1 0
v -1 1 0
vt 0 0
vt 1 0
vt 1 1
vt 0 1
vn 0 0 1
f 1/1/1 2/2/1 3/3/1 4/4/1
)";

constexpr auto scene = R"([image]
size = [16, 16]
[camera]
position = [0, 0, 1]
look_at = [0, 0, 0]
fov = 90
[materials.codes]
type = "diffuse"
texture = "codes.png"
[[meshes]]
file = "square.obj"
material = "codes"
[[lights]]
type = "directional"
direction = [0, 0, -1]
)";

// All 256 in each channel, each time among other neighbours.
std::array<int, 3> codes(int texel) {
    return {texel, 255 - texel, texel * 37 % 256};
}

class Stage08Gamma : public Cli {
protected:
    void SetUp() override {
        Image picture(16, 16);
        for (int i = 0; i < 256; ++i) {
            const auto [r, g, b] = codes(i);
            picture.pixels[std::size_t(i)] = glm::vec3(r, g, b) / 255.0F;
        }
        write_image(picture, folder.path() / "codes.png", Transfer::none);
        folder.write("square.obj", square);
        folder.write("scene.toml", scene);
    }

    // Of a stage's picture, what it has for a code, channel by channel; with each code in each.
    std::array<std::array<double, 256>, 3> by_code(const std::string &stage,
                                                   const std::string &picture,
                                                   const std::string &decode = "srgb",
                                                   const std::string &encode = "srgb") const {
        std::vector<std::string> arguments{"scene.toml", "--out", picture};
        if (stage == "08_gamma") {
            arguments.insert(arguments.end(),
                             {"--method", "decode=" + decode, "--method", "encode=" + encode});
        }
        expect_done(run(stage, arguments));
        const PictureFile file = read_picture_file(folder.path() / picture);
        EXPECT_EQ(file.values.size(), 3U * 256);
        std::array<std::array<double, 256>, 3> result{};
        for (std::size_t i = 0; i < file.values.size(); ++i) {
            const auto code = std::size_t(codes(int(i / 3)).at(i % 3));
            result.at(i % 3).at(code) = double(file.values[i]);
        }
        return result;
    }
};

// The EXR has the light of each code, within half of a step of the storage's half precision; and a
// millionth, by which float misses the texel's centre.
template <typename Decode>
void expect_light(const std::array<std::array<double, 256>, 3> &seen, Decode decode) {
    for (const auto &channel : seen) {
        for (int code = 0; code < 256; ++code) {
            const double light = decode(code / 255.0);
            EXPECT_NEAR(channel.at(std::size_t(code)), light, light / 2048 + 1e-6) << code;
        }
    }
}

// The PNG has, for each code, the one nearest to what `expected` makes of it. Storage may be off by
// a twentieth.
template <typename Expected>
void expect_codes(const std::array<std::array<double, 256>, 3> &seen, Expected expected) {
    for (const auto &channel : seen) {
        for (int code = 0; code < 256; ++code) {
            EXPECT_NEAR(255 * channel.at(std::size_t(code)), 255 * expected(code / 255.0), 0.55)
                << code;
        }
    }
}

double itself(double value) {
    return value;
}

TEST_F(Stage08Gamma, ExrHasTheDecodedLight) {
    expect_light(by_code("08_gamma", "a.exr"), exact::srgb_decode);
    expect_light(by_code("08_gamma", "a.exr", "srgb", "2.2"), exact::srgb_decode);
    expect_light(by_code("08_gamma", "a.exr", "2.2"), exact::power_decode);
}

TEST_F(Stage08Gamma, PngHasEachCodeBack) {
    expect_codes(by_code("08_gamma", "a.png"), itself);
    expect_codes(by_code("08_gamma", "a.png", "2.2", "2.2"), itself);
}

// The two curves are up to 8 codes apart, so that a wrong pair shows.
TEST_F(Stage08Gamma, MixedCurvesMoveTheCodes) {
    expect_codes(by_code("08_gamma", "a.png", "srgb", "2.2"),
                 [](double value) { return exact::power_encode(exact::srgb_decode(value)); });
    expect_codes(by_code("08_gamma", "a.png", "2.2", "srgb"),
                 [](double value) { return exact::srgb_encode(exact::power_decode(value)); });
}

// Before, neither was done: the codes come back, but as if they were light.
TEST_F(Stage08Gamma, Stage06HasNone) {
    expect_codes(by_code("06_textures", "a.png"), itself);
    expect_light(by_code("06_textures", "a.exr"), itself);
}

}  // namespace
}  // namespace stagelight::cli
