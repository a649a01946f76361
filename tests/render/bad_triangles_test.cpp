// SPDX-License-Identifier: MIT
// Triangles as bad files have them, without an area or twice in one place: what is drawn is what is
// drawn without them.
#include <array>
#include <cmath>

#include "device/bvh.h"
#include "reference/reference.h"
#include "render/on_each_device.h"

namespace stagelight::render {
namespace {

class Stage09BadTriangles : public OnEachDevice {
protected:
    Stage09BadTriangles() {
        scene.width = scene.height = 65;
        scene.max_depth = 4;
        add_material(scene, diffuse({0.9, 0.8, 0.7}));
        add_material(scene, mirror({0.9, 0.9, 0.9}));
        add_directional_light(scene, {0.3, -1, -0.5}, {1, 1, 1}, 0.5);
        add_point_light(scene, {0, 3, 4}, {1, 1, 1}, 10);
        add_ball(scene, {-0.6, 0, 0}, 0.8, 12, 0);
        add_ball(scene, {0.7, 0.2, 0.3}, 0.6, 12, 1);
    }
    // With the tree and by trying all, and by the reference.
    void expect_same_as(const Scene &good) const {
        for (const char *stage : {"09_tree", "05_meshes"}) {
            EXPECT_EQ(draw(stage, scene).image.pixels, draw(stage, good).image.pixels) << stage;
        }
        const Settings settings{.width = 65, .height = 65, .max_depth = 4};
        EXPECT_EQ(reference::render<double>(scene, settings).image.pixels,
                  reference::render<double>(good, settings).image.pixels);
    }

    Scene scene = one_pixel({0, 0, 4}, {0, 0, 0});
};
INSTANTIATE_TEST_SUITE_P(Devices, Stage09BadTriangles, each_device(), device_name);

// Once before and once after all others, so that the tree meets them in another order.
TEST_P(Stage09BadTriangles, ThatAreThereTwiceAreDrawnOnce) {
    const Scene good = scene;
    const std::vector<Triangle> all = scene.triangles;
    scene.triangles.insert(scene.triangles.end(), all.rbegin(), all.rend());
    expect_same_as(good);
}

TEST_P(Stage09BadTriangles, ThatArePointsOrLinesAreNotThere) {
    const Scene good = scene;
    Dice dice;
    for (int i = 0; i < 3000; ++i) {
        const dvec3 at = dice.in_cube(1);
        const dvec3 along = glm::dvec3(glm::vec3(dice.in_cube(1)));
        const dvec3 normal = dice.direction();
        // A point, a line there and back, and corners in a row, which float holds exactly.
        const std::array<std::array<dvec3, 3>, 3> corners{
            {{at, at, at}, {at, at + along, at}, {dvec3(0), along, 4.0 * along}}};
        const auto &[a, b, c] = corners[std::size_t(i) % 3];
        add_triangle(scene, {a, normal, {}}, {b, normal, {}}, {c, normal, {}}, 0);
    }
    expect_same_as(good);
}

// Next to no area: they may be hit or missed, as rounding has it, but what is seen is a colour.
TEST_P(Stage09BadTriangles, ThatAreSplintersGiveNumbers) {
    Dice dice;
    for (int i = 0; i < 20000; ++i) {
        const dvec3 at = dice.in_cube(1.5);
        const dvec3 along = dice.in_cube(1);
        const dvec3 aside = std::pow(10, dice.between(-12, -5)) * dice.in_cube(1);
        add_triangle(scene, {at, dice.direction(), {}}, {at + along, dice.direction(), {}},
                     {at + dice.between(0, 2) * along + aside, dice.direction(), {}}, i % 2);
    }
    for (const glm::vec3 &pixel : draw("09_tree", scene).image.pixels) {
        ASSERT_TRUE(pixel.x >= 0 && pixel.y >= 0 && pixel.z >= 0) << pixel.x << ' ' << pixel.y;
        ASSERT_LT(pixel.x + pixel.y + pixel.z, 1e3);
    }
}

// All centres in one place: nothing divides them but their number.
TEST(Stage09Tree, OfAMillionTrianglesInOnePlaceIsShallow) {
    Scene scene;
    add_flat_triangle(scene, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0);
    scene.triangles.resize(1000000, scene.triangles.front());
    const Bvh bvh = build_bvh(scene);
    EXPECT_EQ(bvh.triangles.size(), scene.triangles.size());
    EXPECT_LE(bvh.stack_size, 3 * 18 + 1) << "1000000 / 8 leaves, by halves";
}

}  // namespace
}  // namespace stagelight::render
