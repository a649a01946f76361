// SPDX-License-Identifier: MIT
#include "reference/textures.h"

#include <cmath>

#include "kernels/on_device.h"
#include "kernels/pictures.h"
#include "kernels/worst.h"
#include "reference/scenes.h"

namespace stagelight {
namespace {

using glm::dvec3, glm::vec3, glm::vec4;
using reference::Dice;

using KernelsStage06Coordinates = OnDevice;
INSTANTIATE_TEST_SUITE_P(On, KernelsStage06Coordinates, each_device(), device_name);

TEST_P(KernelsStage06Coordinates, OfASphereMatchDouble) {
    Dice dice;
    std::vector<vec4> normals;
    for (int i = 0; i < 8192; ++i) {
        dvec3 normal = dice.direction();
        if (i % 4 == 1) {  // all but at a pole
            normal *= dvec3(1, 0, 1) * std::pow(10, dice.between(-8, 0));
            normal.y = i % 8 == 1 ? 1 : -1;
        } else if (i % 4 == 2) {  // all but on the seam
            normal.x = std::pow(10, dice.between(-8, -1)) * (i % 8 == 2 ? 1 : -1);
            normal.z = -std::abs(normal.z);
        }
        // Rounding leaves a unit vector longer or shorter by about an ulp.
        normals.emplace_back(vec3(glm::normalize(normal) * (1 + dice.between(-2, 2) * ulp)), 0);
    }
    const auto results = build("texture.cl").run<glm::vec2>("coordinates", normals);
    Worst u("u"), v("v"), range("u and v from 0 to 1");
    for (std::size_t i = 0; i < results.size(); ++i) {
        const glm::dvec2 truth = reference::sphere_coordinates(dvec3(normals[i]));
        for (const float coordinate : {results[i].x, results[i].y}) {
            range.compare(i, coordinate, 0.5, 0.5);
        }
        // At the seam 0 and 1 are the same place. OpenCL C's atan2 is within 6 ulp of at most
        // pi, its asin within 4 of pi / 2.
        const double turns = std::round(double(results[i].x) - truth.x);
        u.compare(i, results[i].x - turns, truth.x, 4 * ulp);
        v.compare(i, results[i].y, truth.y, 4 * ulp);
    }
    u.expect(8192);
    v.expect(8192);
    range.expect(16384);
}

// docs/shading.md: u = ½ + atan2(x, z) / 2π, v = ½ - asin(y) / π.
TEST_P(KernelsStage06Coordinates, PolesAndSeamAreWhereTheyBelong) {
    const float above_1 = 1.0000001F;
    const std::vector<vec4> normals{{0, 0, 1, 0},        {1, 0, 0, 0},
                                    {-1, 0, 0, 0},       {0, 0, -1, 0},
                                    {-0.0F, 0, -1, 0},   {0, 1, 0, 0},
                                    {0, -1, 0, 0},       {0, above_1, 0, 0},
                                    {0, -above_1, 0, 0}, {0, 0.5F, 0.8660254F, 0}};
    const std::vector<glm::vec2> expected{{0.5F, 0.5F}, {0.75F, 0.5F},   {0.25F, 0.5F}, {1, 0.5F},
                                          {0, 0.5F},    {0.5F, 0},       {0.5F, 1},     {0.5F, 0},
                                          {0.5F, 1},    {0.5F, 1 / 3.0F}};
    const auto results = build("texture.cl").run<glm::vec2>("coordinates", normals);
    for (std::size_t i = 0; i < results.size(); ++i) {
        EXPECT_NEAR(results[i].x, expected[i].x, 4 * ulp) << "u, case " << i;
        EXPECT_NEAR(results[i].y, expected[i].y, 4 * ulp) << "v, case " << i;
    }
}

using KernelsStage06Cutout = OnDevice;
INSTANTIATE_TEST_SUITE_P(On, KernelsStage06Cutout, each_device(), device_name);
using KernelsStage06Texture = OnDevice;
INSTANTIATE_TEST_SUITE_P(On, KernelsStage06Texture, each_device(), device_name);

// One colour a picture: whatever is filtered, a neighbour's colour, or the black beside a small
// picture on its layer, would show.
TEST_P(KernelsStage06Texture, EveryPictureHasItsOwnColor) {
    const Scene scene = scene_of_pictures([](int picture, int, int) {
        return std::array{10 + 30 * picture, 200 - 20 * picture, picture % 2 == 0 ? 50 : 150};
    });
    expect_colors(build("texture.cl", with_pictures), scene, Transfer::none, 0, 4 * ulp);
}

// Of equal pictures each has a layer of its own. PoCL 3.1 reads the wrong one with normalised
// coordinates.
TEST_P(KernelsStage06Texture, EqualPicturesLieOnLayersOfTheirOwn) {
    Scene scene;
    std::vector<vec4> middles;
    for (int i = 0; i < 5; ++i) {
        const auto red = std::uint8_t(10 + 50 * i);
        scene.textures.push_back(reference::texture_of(2, 1, {red, 0, 0, 255, red, 0, 0, 255}));
        scene.materials.push_back({.texture = i, .where = {}});
        middles.emplace_back(0.5, 0.5, i, 0);
    }
    ASSERT_EQ(pages_of(scene, device()).layers, 5U);
    const auto colors = build("texture.cl", with_pictures).run_in<vec4>(scene, "colors", middles);
    for (std::size_t i = 0; i < colors.size(); ++i) {
        EXPECT_NEAR(255 * colors[i].x, 10 + 50 * double(i), 0.1);
    }
}

// All texels at random: the place is rounded in proportion to the size, and a step from one
// texel to the next is as high as 1 a channel. rusticl filters textures of 8 bits in 8 bits:
// each of the two blends' weights by up to 1 / 256, the colour by up to half of
// 1 / 255.
TEST_P(KernelsStage06Texture, TheFilterBlendsFourTexelsAcrossTheWrapToo) {
    Dice dice;
    const Scene scene = scene_of_pictures([&](int, int, int) {
        return std::array{int(dice.between(0, 256 - 1e-6)), int(dice.between(0, 256 - 1e-6)),
                          int(dice.between(0, 256 - 1e-6))};
    });
    expect_colors(build("texture.cl", with_pictures), scene, Transfer::none, 4 * ulp,
                  on_rusticl() ? 2.0 / 256 + 0.5 / 255 : 4 * ulp);
}

Scene random_pictures() {
    Dice dice;
    Scene scene = scene_of_pictures([&](int, int, int) {
        return std::array{int(dice.between(0, 256 - 1e-6)), int(dice.between(0, 256 - 1e-6)),
                          int(dice.between(0, 256 - 1e-6))};
    });
    for (Texture &texture : scene.textures) {
        for (std::size_t i = 3; i < texture.texels.size(); i += 4) {
            texture.texels[i] = std::uint8_t(dice.between(0, 256 - 1e-6));
        }
    }
    return scene;
}

// Each way to wrap u beside each to wrap v: what the borders hold shows at the edges.
TEST_P(KernelsStage06Texture, WrapsEachAxisInEachWay) {
    Scene scene = random_pictures();
    wrap_in_all_ways(scene);
    SceneNeeds needs = with_pictures;
    needs.emplace_back("HAS_WRAPS", 1);
    expect_colors(build("texture.cl", needs), scene, Transfer::none, 4 * ulp,
                  on_rusticl() ? 2.0 / 256 + 0.5 / 255 : 4 * ulp);
}

// Alphas lie in a buffer, one picture after another, and are filtered in float on every device.
TEST_P(KernelsStage06Cutout, AlphasAreBlendedAndWrappedAsColorsAre) {
    Scene scene = random_pictures();
    wrap_in_all_ways(scene);
    scene.vertices.resize(3);
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        scene.materials[i].alpha_cutoff = 0.5;
        scene.triangles.push_back({.vertices = {0, 1, 2}, .material = int(i)});
    }
    const SceneNeeds needs{{"HAS_MATERIALS", 1}, {"HAS_TRIANGLES", 1},     {"HAS_TEXTURES", 1},
                           {"HAS_WRAPS", 1},     {"HAS_MESH_TEXTURES", 1}, {"HAS_CUTOUTS", 1}};
    const std::vector<vec4> at = places(scene);
    const auto alphas = build("texture.cl", needs).run_in<float>(scene, "alphas_at", at);
    Worst alpha("alpha");
    for (std::size_t i = 0; i < alphas.size(); ++i) {
        const Texture &texture = scene.textures[std::size_t(at[i].z)];
        const double truth = reference::sample_alpha(texture, glm::dvec2(at[i].x, at[i].y));
        const double size = 1 + std::max(texture.width, texture.height);
        alpha.compare(i, alphas[i], truth, 4 * ulp * size + 4 * ulp);
    }
    alpha.expect(100000);
}

TEST_P(KernelsStage06Texture, AMaterialWithoutATextureIsWhite) {
    const Scene scene = scene_of_pictures([](int, int, int) { return std::array{0, 0, 0}; });
    const std::vector<vec4> place{{0.3, 0.7, scene.materials.size() - 1, 0}};
    const auto colors = build("texture.cl", with_pictures).run_in<vec4>(scene, "colors", place);
    EXPECT_EQ(colors[0], vec4(1));
}

}  // namespace
}  // namespace stagelight
