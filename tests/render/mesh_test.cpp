// SPDX-License-Identifier: MIT
// Stage 05 against answers worked out by hand.
#include "render/on_each_device.h"

namespace stagelight::render {
namespace {

class Stage05Triangle : public OnEachDevice {};
INSTANTIATE_TEST_SUITE_P(Devices, Stage05Triangle, each_device(), device_name);

constexpr auto stage = "05_meshes";
const dvec3 paint(0.9, 0.5, 0.2), white(1, 1, 1);
const dvec3 a(-1, -1, 0), b(1, -1, 0), top(0, 2, 0);  // its centroid is the origin

// At the centroid each corner's normal counts a third: N = (0.6, 0.6, 2.6) / |…| of these three.
// The light comes along -z, so that the cosine is N.z; from behind, N is turned, and lit likewise.
TEST_P(Stage05Triangle, BlendsItsNormalsAtTheCentroid) {
    const dvec3 blended = glm::normalize(dvec3(0.6, 0.6, 2.6));
    for (const double side : {1.0, -1.0}) {
        Scene scene = one_pixel({0, 0, side * 3}, {0, 0, 0});
        const int material = add_material(scene, diffuse(paint));
        add_triangle(scene, {a, {0.6, 0, 0.8}, {}}, {b, {0, 0.6, 0.8}, {}}, {top, {0, 0, 1}, {}},
                     material);
        add_directional_light(scene, {0, 0, -side}, white, 0.8);
        expect_color(draw(stage, scene).image, 0, 0, paint * 0.8 * blended.z);
    }
}

// Right of x = 0 the point sees the light past the edge of a triangle half-way up.
TEST_P(Stage05Triangle, ShadowsUpToItsEdge) {
    Scene scene = one_pixel({0, 0.01, 0}, {0, 0, 0});
    scene.camera.up = {0, 0, -1};
    scene.camera.fov = 90;
    scene.width = 8;
    add_plane(scene, {0, 1, 0}, {0, 0, 0}, diffuse(white));
    add_flat_triangle(scene, {0, 1, -2}, {0, 1, 2}, {-3, 1, 0});
    add_point_light(scene, {0, 2, 0}, white, 4);
    const auto expect_edge = [&] {
        const Frame frame = draw(stage, scene);
        for (int x = 0; x < 8; ++x) {
            expect_color(frame.image, x, 0, x < 4 ? dvec3(0) : white, 1e-3);
        }
        EXPECT_EQ(frame.rays.shadow, 8u);
    };
    expect_edge();
    scene.lights.clear();
    add_directional_light(scene, {0, -1, 0}, white, 1);
    expect_edge();
    // Above the light it shadows nothing, though the lines go on to it from x > 0.
    scene.lights.clear();
    add_point_light(scene, {0, 0.5, 0}, white, 0.25);
    const Image image = draw(stage, scene).image;
    for (int x = 0; x < 8; ++x) {
        expect_color(image, x, 0, white, 1e-3);
    }
}

// A mirror in the plane x = z sends the eye's way to the left, to a wall that is lit at 45 degrees.
TEST_P(Stage05Triangle, Reflects) {
    Scene scene = one_pixel({0, 0, 3}, {0, 0, 0});
    const int silver = add_material(scene, mirror({0.9, 0.8, 0.7}));
    add_flat_triangle(scene, {-1, -1, -1}, {1, -1, 1}, {0, 1, 0}, silver);
    add_plane(scene, {1, 0, 0}, {-5, 0, 0}, diffuse(paint));
    add_directional_light(scene, glm::normalize(dvec3(-1, -1, 0)), white, 0.5);
    const Frame frame = draw(stage, scene);
    expect_color(frame.image, 0, 0, dvec3(0.9, 0.8, 0.7) * paint * 0.5 * std::sqrt(0.5));
    EXPECT_EQ(frame.rays.reflection, 1u);
    EXPECT_EQ(frame.rays.shadow, 1u);
}

}  // namespace
}  // namespace stagelight::render
