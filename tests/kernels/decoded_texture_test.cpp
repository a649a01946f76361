// SPDX-License-Identifier: MIT
// Textures from stage 08 on: decoded once, on load, and stored so that their dark tones are kept.
#include <cmath>

#include "exact_curves.h"
#include "kernels/pictures.h"

namespace stagelight {
namespace {

using glm::vec3, glm::vec4;
using reference::Dice;

using KernelsStage08Texture = OnDevice;
INSTANTIATE_TEST_SUITE_P(On, KernelsStage08Texture, each_device(), device_name);

constexpr Transfer curves[] = {Transfer::srgb, Transfer::power};

// Half of the step between half-precision numbers just below 1.
constexpr double half_rounding = 1.0 / 4096;

TEST_P(KernelsStage08Texture, EveryLayerHasItsOwnColor) {
    const Scene scene = scene_of_pictures([](int picture, int, int) {
        return std::array{10 + 30 * picture, 200 - 20 * picture, picture % 2 == 0 ? 50 : 150};
    });
    for (const Transfer decode : curves) {
        expect_colors(build("texture.cl", with_pictures, {}, decode), scene, decode, 0,
                      half_rounding);
    }
}

// Light is blended, and not codes. Unlike stage 06's 8 bits, rusticl filters these in float.
TEST_P(KernelsStage08Texture, TheFilterBlendsLight) {
    Dice dice;
    const auto code = [&dice] { return int(dice.between(0, 256 - 1e-6)); };
    const Scene scene = scene_of_pictures([&](int, int, int) {
        const int red = code(), green = code();
        return std::array{red, green, code()};
    });
    for (const Transfer decode : curves) {
        expect_colors(build("texture.cl", with_pictures, {}, decode), scene, decode, 4 * ulp,
                      std::sqrt(3.0) * half_rounding);
    }
}

// Decode, store, read through the filter, encode, round: each of the 256 codes is itself again, off
// by a twentieth of a code at most. 8 linear bits would lose most of the dark ones.
TEST_P(KernelsStage08Texture, All256CodesComeBack) {
    Scene scene;
    std::vector<std::uint8_t> texels;
    std::vector<vec4> centres;
    for (int code = 0; code < 256; ++code) {
        texels.insert(texels.end(), {std::uint8_t(code), std::uint8_t(255 - code), 0, 255});
        centres.emplace_back((code % 16 + 0.5) / 16, (code / 16 + 0.5) / 16, 0, 0);
    }
    scene.textures.push_back(reference::texture_of(16, 16, texels));
    scene.materials.push_back({.texture = 0, .where = {}});
    for (const Transfer decode : curves) {
        const auto encode = decode == Transfer::srgb ? exact::srgb_encode : exact::power_encode;
        const auto colors =
            build("texture.cl", with_pictures, {}, decode).run_in<vec4>(scene, "colors", centres);
        Worst red("red"), green("green");
        for (int code = 0; code < 256; ++code) {
            const auto i = std::size_t(code);
            red.compare(i, 255 * encode(double(colors[i].x)), code, 0.05);
            green.compare(i, 255 * encode(double(colors[i].y)), 255 - code, 0.05);
            EXPECT_EQ(colors[i].z, 0);
        }
        red.expect(256);
        green.expect(256);
    }
}

// A texel takes twice its 8-bit room, and before stage 08 none of that.
TEST_P(KernelsStage08Texture, TakesEightBytesATexel) {
    const cl::Context context(device());
    const Scene scene = scene_of_pictures([](int, int, int) { return std::array{1, 2, 3}; });
    const std::size_t texels = pages_of(scene, device()).texels();
    EXPECT_EQ(TextureArray(context, device(), scene, Transfer::none).bytes(), 4 * texels);
    for (const Transfer decode : curves) {
        const TextureArray array(context, device(), scene, decode);
        EXPECT_EQ(array.bytes(), 8 * texels);
        EXPECT_GE(array.image().getInfo<CL_MEM_SIZE>(), 8 * texels);
    }
}

}  // namespace
}  // namespace stagelight
