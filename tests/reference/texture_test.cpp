// SPDX-License-Identifier: MIT
#include "reference/textures.h"

#include "exact_curves.h"
#include "scenes.h"

namespace stagelight::reference {
namespace {

using glm::dvec2;

// Each texel's red is its number, left to right and top to bottom; its alpha is nonsense.
Texture numbered(int width, int height) {
    Texture texture = texture_of(width, height, {});
    for (int i = 0; i < width * height; ++i)
        texture.texels.insert(texture.texels.end(), {std::uint8_t(i), 0, 255, std::uint8_t(7 * i)});
    return texture;
}

double red(const Texture &texture, dvec2 uv) {
    return sample_texture(texture, Transfer::none, uv).x * 255;
}

// 4 by 2: the centre of texel (i, j) lies at ((i + ½) / 4, (j + ½) / 2).
TEST(ReferenceStage06Texture, ShowsEachTexelAtItsCentre) {
    const Texture texture = numbered(4, 2);
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 4; ++i)
            EXPECT_NEAR(red(texture, {(i + 0.5) / 4, (j + 0.5) / 2}), 4 * j + i, 1e-12);
    expect_near(sample_texture(texture, Transfer::none, dvec2(0.125, 0.25)), {0, 0, 1}, 1e-15);
}

// 4 by 4. A quarter of the way from texel 5 to texel 6 to the right, and three quarters down:
// (5 · ¾ + 6 · ¼) · ¼ + (9 · ¾ + 10 · ¼) · ¾.
TEST(ReferenceStage06Texture, BlendsTheFourAround) {
    EXPECT_NEAR(red(numbered(4, 4), {1.75 / 4, 2.25 / 4}), 5.25 * 0.25 + 9.25 * 0.75, 1e-12);
}

// At u = 0 the last and the first column blend in equal parts, at v = 0 the last and the first row.
TEST(ReferenceStage06Texture, WrapsInBothDirections) {
    const Texture texture = numbered(4, 2);
    EXPECT_NEAR(red(texture, {0, 0.25}), (0 + 3) / 2.0, 1e-12);
    EXPECT_NEAR(red(texture, {1, 0.25}), (0 + 3) / 2.0, 1e-12);
    EXPECT_NEAR(red(texture, {0.125, 0}), (0 + 4) / 2.0, 1e-12);
    for (const double turns : {-3.0, -1.0, 1.0, 1e10}) {
        EXPECT_NEAR(red(texture, {0.375 + turns, 0.75}), 5, 1e-9) << turns;
        EXPECT_NEAR(red(texture, {0.375, 0.75 - turns}), 5, 1e-9) << turns;
    }
    EXPECT_NEAR(red(numbered(1, 1), {0.3, 0.9}), 0, 0) << "one texel is all its neighbours";
}

// 4 texels in a row, numbered 0 to 3: what is beyond the edges at the centres of texels to both
// sides.
TEST(ReferenceStage06Texture, ClampsAndMirrors) {
    Texture texture = numbered(4, 1);
    const auto at = [&](int column) { return red(texture, {(column + 0.5) / 4, 0.5}); };
    texture.wrap_u = Wrap::clamp;
    for (const auto &[column, shown] :
         {std::pair{-9, 0}, {-1, 0}, {0, 0}, {3, 3}, {4, 3}, {40, 3}}) {
        EXPECT_NEAR(at(column), shown, 1e-12) << column;
    }
    EXPECT_NEAR(red(texture, {1e10, 0.5}), 3, 1e-12);
    EXPECT_NEAR(red(texture, {-0.01, 0.5}), 0, 1e-12);
    texture.wrap_u = Wrap::mirror;
    for (const auto &[column, shown] : {std::pair{-5, 3},
                                        {-4, 3},
                                        {-1, 0},
                                        {0, 0},
                                        {3, 3},
                                        {4, 3},
                                        {5, 2},
                                        {7, 0},
                                        {8, 0},
                                        {9, 1}}) {
        EXPECT_NEAR(at(column), shown, 1e-9) << column;
    }
    EXPECT_NEAR(red(texture, {1, 0.5}), 3, 1e-12) << "the last texel beside itself";
    EXPECT_NEAR(red(texture, {0, 0.5}), 0, 1e-12);
}

TEST(ReferenceStage06Texture, WrapsEachAxisInItsOwnWay) {
    Texture texture = numbered(4, 2);
    texture.wrap_u = Wrap::clamp;
    EXPECT_NEAR(red(texture, {1.875, 1.25}), 3, 1e-12) << "u clamped, v repeated";
    texture.wrap_v = Wrap::mirror;
    EXPECT_NEAR(red(texture, {1.875, 1.25}), 4 + 3, 1e-12) << "v mirrored";
}

// Alpha 0 and 255 side by side, a quarter of the way between them; no curve is applied to it.
TEST(ReferenceStage06Cutout, AlphaIsBlended) {
    const Texture texture = texture_of(2, 1, {9, 9, 9, 0, 9, 9, 9, 255});
    EXPECT_NEAR(sample_alpha(texture, dvec2(0.375, 0.5)), 0.25, 1e-15);
    EXPECT_EQ(sample_alpha(texture_of(1, 1, {0, 0, 0, 255}), dvec2(0.3, 0.77)), 1);
}

// A card of alpha 1 left and 0 right, in front of a wall.
Scene card() {
    Scene scene;
    Material material = diffuse({1, 1, 1});
    material.texture = 0;
    material.alpha_cutoff = 0.5;
    scene.textures.push_back(texture_of(2, 1, {255, 255, 255, 255, 255, 255, 255, 0}));
    scene.textures[0].wrap_u = Wrap::clamp;
    const dvec3 n(0, 0, 1);
    const int cut = add_material(scene, material);
    add_triangle(scene, {{-1, -1, 0}, n, {0, 1}}, {{1, -1, 0}, n, {1, 1}}, {{1, 1, 0}, n, {1, 0}},
                 cut);
    add_triangle(scene, {{-1, -1, 0}, n, {0, 1}}, {{1, 1, 0}, n, {1, 0}}, {{-1, 1, 0}, n, {0, 0}},
                 cut);
    add_plane(scene, n, {0, 0, -1}, diffuse({0, 1, 0}));
    return scene;
}

TEST(ReferenceStage06Cutout, RaysAndLinesGoThroughIt) {
    const Scene scene = card();
    const World<double> world(scene);
    for (const auto &[x, distance] : {std::pair{-0.5, 1.0}, {0.5, 2.0}}) {
        EXPECT_NEAR(world.closest_hit(ray({x, 0.1, 1}, {0, 0, -1}))->distance, distance, 1e-12);
        EXPECT_EQ(world.blocked(ray({x, 0.1, -0.5}, {0, 0, 1})), x < 0);
        EXPECT_EQ(world.blocked(Line<double>{{x, 0.1, -0.5}, {x, 0.1, 1}}), x < 0);
    }
}

TEST(ReferenceStage06Cutout, GlassIsWhole) {
    Scene scene = card();
    scene.materials[0].type = MaterialType::dielectric;
    EXPECT_NEAR(World<double>(scene).closest_hit(ray({0.5, 0.1, 1}, {0, 0, -1}))->distance, 1,
                1e-12);
}

TEST(ReferenceStage06Meshes, ColorsOfVerticesAreBlended) {
    Scene scene;
    const dvec3 n(0, 0, 1);
    add_triangle(scene, {{0, 0, 0}, n, {}, {1, 0, 0}}, {{1, 0, 0}, n, {}, {0, 1, 0}},
                 {{0, 1, 0}, n, {}, {0, 0, 1}}, add_material(scene, diffuse({1, 0.5, 1})));
    add_directional_light(scene, {0, 0, -1}, {1, 1, 1}, 1);
    expect_near(seen(scene, ray({0.25, 0.125, 1}, {0, 0, -1})), {0.625, 0.125, 0.125}, 1e-12);
}

// v runs from the north pole to the south, all of it; u runs around, from behind (-z) over the
// left (-x), the front (+z, in the middle) and the right back to behind.
TEST(ReferenceStage06Sphere, CoordinatesSpanThePicture) {
    const auto at = [](dvec3 q) { return dvec3(sphere_coordinates(q), 0); };
    const double r = std::sqrt(0.5);
    expect_near(at({0, 0, 1}), {0.5, 0.5, 0}, 1e-15);
    expect_near(at({1, 0, 0}), {0.75, 0.5, 0}, 1e-15);
    expect_near(at({-1, 0, 0}), {0.25, 0.5, 0}, 1e-15);
    expect_near(at({1e-12, 0, -1}), {1, 0.5, 0}, 1e-12);
    expect_near(at({-1e-12, 0, -1}), {0, 0.5, 0}, 1e-12);
    expect_near(at({0, r, r}), {0.5, 0.25, 0}, 1e-15);
    expect_near(at({0, -r, -r}), {1, 0.75, 0}, 1e-15);
}

TEST(ReferenceStage06Sphere, PolesAreNumbers) {
    for (const double pole : {1.0, -1.0})
        for (const double beyond : {0.0, 1e-7, -1e-16}) {
            const auto uv = sphere_coordinates(Vec<float>(dvec3(0, pole * (1 + beyond), 0)));
            EXPECT_NEAR(uv.y, pole > 0 ? 0 : 1, 1e-6);
            EXPECT_TRUE(uv.x >= 0 && uv.x <= 1) << uv.x;
        }
}

// Across the seam at the back of a globe the picture runs on.
TEST(ReferenceStage06Sphere, TheSeamDoesNotShow) {
    const Texture texture = numbered(8, 4);
    EXPECT_NEAR(red(texture, sphere_coordinates(dvec3(1e-9, 0.1, -1))),
                red(texture, sphere_coordinates(dvec3(-1e-9, 0.1, -1))), 1e-6);
}

// A light from the eye: N · L = 1 where the globe is met head on, so what is seen there is the
// colour times the texel.
TEST(ReferenceStage06Sphere, IsPaintedAsSeenFromOutsideAndInside) {
    Scene scene;
    scene.textures.push_back(numbered(4, 1));
    Material material = diffuse({0.5, 1, 1});
    material.texture = 0;
    add_sphere(scene, {1, 2, 3}, 2, material);
    for (const auto &[toward, texel] : {std::pair{dvec3(-1, 0, -1), 2},
                                        {dvec3(1, 0, -1), 1},
                                        {dvec3(1, 0, 1), 0},
                                        {dvec3(-1, 0, 1), 3}}) {
        scene.lights.clear();
        add_directional_light(scene, glm::normalize(toward), {1, 1, 1}, 1);
        expect_near(seen(scene, ray(dvec3(1, 2, 3) - 5.0 * toward, toward)),
                    {0.5 * texel / 255, 0, 1}, 1e-12);
        // From inside, the light from the eye at the centre: the same place, seen through.
        scene.lights.clear();
        add_point_light(scene, {1, 2, 3}, {1, 1, 1}, 4);
        expect_near(seen(scene, ray({1, 2, 3}, -toward)), {0.5 * texel / 255, 0, 1}, 1e-12);
    }
}

// Coordinates of the corners blend like their normals: at u = v = ¼ of the triangle half of a's
// (0, 0), a quarter of b's (1, 0) and of c's (0, 1).
TEST(ReferenceStage06Meshes, CoordinatesAreBlended) {
    Scene scene;
    scene.textures.push_back(numbered(4, 4));
    Material material = diffuse({1, 1, 1});
    material.texture = 0;
    const dvec3 n(0, 0, 1);
    add_triangle(scene, {{0, 0, 0}, n, {0, 0}}, {{1, 0, 0}, n, {1, 0}}, {{0, 1, 0}, n, {0, 1}},
                 add_material(scene, material));
    add_directional_light(scene, {0, 0, -1}, {1, 1, 1}, 1);
    EXPECT_NEAR(seen(scene, ray({0.375, 0.125, 1}, {0, 0, -1})).x * 255, 1, 1e-12);
    EXPECT_NEAR(seen(scene, ray({0.125, 0.625, 1}, {0, 0, -1})).x * 255, 8, 1e-12);
    EXPECT_NEAR(seen(scene, ray({0.25, 0.25, 1}, {0, 0, -1})).x * 255, (0 + 1 + 4 + 5) / 4.0,
                1e-12);
}

// A quarter, half and three quarters of the way, worked out in decimal to 30 digits; and the ends.
TEST(ReferenceStage08Decode, FollowsItsCurve) {
    EXPECT_NEAR(light_of(Transfer::srgb, 0.25), 0.050876088172, 1e-12);
    EXPECT_NEAR(light_of(Transfer::srgb, 0.5), 0.214041140482, 1e-12);
    EXPECT_NEAR(light_of(Transfer::srgb, 0.75), 0.522521553968, 1e-12);
    EXPECT_NEAR(light_of(Transfer::srgb, 0.04), 0.04 / 12.92, 1e-15) << "below the corner";
    EXPECT_NEAR(light_of(Transfer::power, 0.5), 0.217637640824, 1e-12);
    EXPECT_EQ(light_of(Transfer::none, 0.3), 0.3);
    for (const Transfer curve : {Transfer::none, Transfer::srgb, Transfer::power}) {
        EXPECT_EQ(light_of(curve, 0.0), 0);
        EXPECT_NEAR(light_of(curve, 1.0), 1, 1e-15);
    }
}

TEST(ReferenceStage08Decode, IsUndoneByEncoding) {
    for (int code = 0; code < 256; ++code) {
        const double value = code / 255.0;
        EXPECT_NEAR(exact::srgb_encode(light_of(Transfer::srgb, value)), value, 1e-15);
        EXPECT_NEAR(exact::power_encode(light_of(Transfer::power, value)), value, 1e-15);
    }
}

// Half-way between black and white is half the light, which no texel's code of 128 is.
TEST(ReferenceStage08Decode, ComesBeforeTheFilter) {
    const Texture texture = texture_of(2, 1, {0, 0, 0, 255, 255, 255, 255, 255});
    for (const Transfer decode : {Transfer::srgb, Transfer::power}) {
        expect_near(sample_texture(texture, decode, dvec2(0.5, 0.5)), dvec3(0.5), 1e-15);
    }
}

TEST(ReferenceStage08Decode, IsOfEachChannelAndAsTheSettingsSay) {
    Scene scene;
    scene.textures.push_back(texture_of(1, 1, {255, 128, 10, 77}));
    Material material = diffuse({1, 1, 1});
    material.texture = 0;
    add_sphere(scene, {0, 0, 0}, 1, material);
    add_directional_light(scene, {0, 0, -1}, {1, 1, 1}, 1);
    const auto shown = [&](Transfer decode) {
        return seen(scene, ray({0, 0, 3}, {0, 0, -1}), Settings{.decode = decode});
    };
    const double half = 128 / 255.0, dark = 10 / 255.0;
    expect_near(shown(Transfer::none), {1, half, dark}, 1e-12);
    expect_near(shown(Transfer::srgb), {1, exact::srgb_decode(half), exact::srgb_decode(dark)},
                1e-12);
    expect_near(shown(Transfer::power), {1, exact::power_decode(half), exact::power_decode(dark)},
                1e-12);
}

}  // namespace
}  // namespace stagelight::reference
