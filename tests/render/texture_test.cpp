// SPDX-License-Identifier: MIT
// Stage 06 against answers worked out by hand.
#include "render/on_each_device.h"

namespace stagelight::render {
namespace {

class Stage06Texture : public OnEachDevice {};
INSTANTIATE_TEST_SUITE_P(Devices, Stage06Texture, each_device(), device_name);

constexpr auto stage = "06_textures";
constexpr double eight_bits = 1.0 / 255;  // rusticl filters with them

using Texels = std::vector<glm::u8vec3>;

dvec3 color(glm::u8vec3 texel) {
    return dvec3(texel) / 255.0;
}

int add_texture(Scene &scene, int width, int height, const Texels &colors) {
    std::vector<std::uint8_t> texels;
    for (const glm::u8vec3 &c : colors) {
        texels.insert(texels.end(), {c.r, c.g, c.b, 255});
    }
    scene.textures.push_back(texture_of(width, height, texels));
    Material material = diffuse({1, 1, 1});
    material.texture = int(scene.textures.size()) - 1;
    return add_material(scene, material);
}

// A square from -1 to 1 that fills the view, lit head-on by 1: it shows its picture from
// (left, 0) to (left + 1, 1).
void add_picture(Scene &scene, int material, double left) {
    scene.camera.position = {0, 0, 1};
    scene.camera.look_at = {0, 0, 0};
    scene.camera.fov = 90;
    const auto corner = [&](double x, double y) {
        return Vertex{{x, y, 0}, {0, 0, 1}, {left + (x + 1) / 2, (1 - y) / 2}};
    };
    add_triangle(scene, corner(-1, -1), corner(1, -1), corner(1, 1), material);
    add_triangle(scene, corner(-1, -1), corner(1, 1), corner(-1, 1), material);
    add_directional_light(scene, {0, 0, -1}, {1, 1, 1}, 1);
}

const Texels four{{250, 10, 20}, {30, 240, 40}, {50, 60, 230}, {200, 210, 70}};
const Texels six{{10, 10, 10}, {20, 90, 0}, {0, 30, 180}, {240, 40, 0}, {50, 250, 0}, {0, 60, 90}};

// A pixel in the middle of each texel shows that texel alone, rows from the top; in whichever
// layer of the array it lies, beside pictures of another size, and however often it repeats.
TEST_P(Stage06Texture, ShowsATexelAtItsCentre) {
    for (const auto &[shown, left] : {std::pair{0, 0.0}, {1, 0.0}, {1, 1.0}, {0, -3.0}}) {
        Scene scene;
        const std::array materials{add_texture(scene, 2, 2, four), add_texture(scene, 3, 2, six)};
        const Texels &texels = shown == 0 ? four : six;
        scene.width = shown == 0 ? 2 : 3;
        scene.height = 2;
        add_picture(scene, materials.at(std::size_t(shown)), left);
        // A square picture of 3x2 pixels: stretched to the view's shape.
        for (Vertex &vertex : scene.vertices) {
            vertex.position.y *= 2.0 / scene.width;
        }
        const Image image = draw(stage, scene).image;
        for (int i = 0; i < scene.width * 2; ++i) {
            expect_color(image, i % scene.width, i / scene.width, color(texels[std::size_t(i)]),
                         0.1 * eight_bits);
        }
    }
}

// Between two of four texels lies their mean, and at the edge of the picture that of the first and
// the last, since it repeats. The pixel is at u = left + 1/2.
TEST_P(Stage06Texture, BlendsTexelsAcrossTheWrap) {
    for (const auto &[left, first, second] : {std::tuple{0.0, 1, 2}, {0.25, 2, 3}, {0.5, 3, 0}}) {
        Scene scene;
        scene.width = scene.height = 1;
        add_picture(scene, add_texture(scene, 4, 1, four), left);
        const dvec3 mean =
            (color(four[std::size_t(first)]) + color(four[std::size_t(second)])) / 2.0;
        expect_color(draw(stage, scene).image, 0, 0, mean, eight_bits);
    }
}

// Along the equator of a ball with 4 columns: u = 1/2 faces +z, u = 3/4 faces +x, and the seam
// -z, where the first and the last column meet. The light is where the eye is.
TEST_P(Stage06Texture, GoesRoundABall) {
    const auto mean = [](std::size_t i, std::size_t j) {
        return (color(four[i]) + color(four[j])) / 2.0;
    };
    for (const auto &[from, expected] : {std::pair{dvec3(0, 0, 3), mean(1, 2)},
                                         {dvec3(3, 0, 0), mean(2, 3)},
                                         {dvec3(0, 0, -3), mean(3, 0)},
                                         {dvec3(-3, 0, 0), mean(0, 1)}}) {
        Scene scene = one_pixel(from, {0, 0, 0});
        const int globe = add_texture(scene, 4, 1, four);
        scene.spheres.push_back({.radius = 1, .material = globe, .where = {}});
        add_point_light(scene, from, {1, 1, 1}, 4);
        expect_color(draw(stage, scene).image, 0, 0, expected, 1.5 * eight_bits);
    }
}

// The north pole is in the middle of the first row of an odd number, at v = 0: half of the first
// row and half of the last.
TEST_P(Stage06Texture, HasItsFirstRowInTheNorth) {
    for (const double height : {3.0, -3.0}) {
        Scene scene = one_pixel({0, height, 0}, {0, 0, 0});
        scene.camera.up = {0, 0, 1};
        const int globe = add_texture(scene, 1, 4, four);
        scene.spheres.push_back({.radius = 1, .material = globe, .where = {}});
        add_point_light(scene, {0, height, 0}, {1, 1, 1}, 4);
        expect_color(draw(stage, scene).image, 0, 0, (color(four[0]) + color(four[3])) / 2.0,
                     1.5 * eight_bits);
        // Half-way from the pole to the equator, v = 1/4 or 3/4, between rows 0 and 1 or 2 and 3.
        const double side = height > 0 ? 1 : -1;
        scene.camera.position = 3.0 * dvec3(0, side, 1);
        scene.lights[0].position = scene.camera.position;
        const double r = 3 * std::sqrt(2.0) - 1;
        const std::size_t row = height > 0 ? 0 : 2;
        expect_color(draw(stage, scene).image, 0, 0,
                     (color(four[row]) + color(four[row + 1])) / 2.0 * 4.0 / (r * r),
                     1.5 * eight_bits);
    }
}

}  // namespace
}  // namespace stagelight::render
