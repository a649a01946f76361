// SPDX-License-Identifier: MIT
// Whole pictures: number types, repetition, stage 01's view.
#include "reference/camera.h"
#include "reference/reference.h"
#include "scenes.h"

namespace stagelight::reference {
namespace {

const Settings small{.width = 61, .height = 37};

// One of everything.
Scene room() {
    Scene scene;
    scene.camera = {.position = {0.5, 1.5, 5}, .look_at = {0, 0.4, 0}};
    scene.background = {0.2, 0.3, 0.5};
    scene.textures.push_back(texture_of(2, 1, {255, 0, 0, 0, 0, 0, 255, 0}));
    Material globe = diffuse({1, 1, 1});
    globe.texture = 0;
    add_plane(scene, {0, 1, 0}, {0, -0.5, 0}, glossy({0.8, 0.8, 0.8}, 0.2));
    add_sphere(scene, {-1.2, 0, 0}, 0.5, globe);
    add_sphere(scene, {0, 0, 1.5}, 0.5, glass({1, 1, 1}, 1.5, {0, 1, 1}));
    add_sphere(scene, {1.2, 0, -1}, 0.5, mirror({0.9, 0.9, 0.9}));
    add_ball(scene, {0, 0.4, -1}, 0.8, 8, add_material(scene, diffuse({0.9, 0.6, 0.2})));
    add_point_light(scene, {2, 4, 3}, {1, 1, 1}, 20);
    add_directional_light(scene, glm::normalize(dvec3(1, -1, -1)), {0.4, 0.4, 0.5}, 1);
    return scene;
}

// What float rounds off moves no pixel within surfaces by a thousandth; long double agrees with
// double to what the picture's own float holds.
TEST(ReferencePicture, TheNumberTypesAgreeWithinSurfaces) {
    const Scene scene = room();
    const Result is_double = render<double>(scene, small);
    const Result is_float = render<float>(scene, small);
    const Result is_long = render<long double>(scene, small);
    EXPECT_EQ(is_long.edge, is_double.edge);
    int inside = 0;
    for (std::size_t i = 0; i < is_double.edge.size(); ++i) {
        expect_near(is_long.image.pixels[i], is_double.image.pixels[i], 1e-6);
        if (is_double.edge[i])
            continue;
        ++inside;
        expect_near(is_float.image.pixels[i], is_double.image.pixels[i], 1e-3);
    }
    EXPECT_GT(inside, 700) << "of " << is_double.edge.size();
}

// To the bit, however the rows fell to the threads.
TEST(ReferencePicture, IsTheSameEachTime) {
    const Scene scene = room();
    const Result first = render<double>(scene, small);
    for (int i = 0; i < 5; ++i) {
        const Result again = render<double>(scene, small);
        EXPECT_TRUE(again.image.pixels == first.image.pixels);
        EXPECT_TRUE(again.edge == first.edge);
    }
}

// The picture is what each pixel's own ray sees, row 0 at the top.
TEST(ReferencePicture, EachPixelIsARayThroughItsCentre) {
    const Scene scene = room();
    const Image image = render<double>(scene, small).image;
    ASSERT_EQ(image.width, small.width);
    ASSERT_EQ(image.height, small.height);
    for (const auto &[x, y] : {std::pair{0, 0}, {60, 0}, {30, 16}, {31, 15}, {12, 36}})
        expect_near(
            image.at(x, y),
            seen(scene, primary_ray(scene.camera, small.width, small.height, x + 0.5, y + 0.5)),
            1e-7);
}

TEST(ReferenceStage01View, IsAPictureToo) {
    const Result result = render<double>(room(), small, Shown::normals_and_distances);
    // The upper left corner is sky, the lower edge floor: N = +y, so that x and z are in the middle
    // and y is whole, all by the same factor.
    expect_near(result.image.at(0, 0), {0.2, 0.3, 0.5}, 1e-7);
    const dvec3 floor = result.image.at(1, 36);
    expect_near(floor, floor.y * dvec3(0.5, 1, 0.5), 1e-7);
    EXPECT_GE(floor.y, 0.8);
    EXPECT_GT(std::count(result.edge.begin(), result.edge.end(), 1), 100);
}

}  // namespace
}  // namespace stagelight::reference
