// SPDX-License-Identifier: MIT
// A kernel is built for what a scene has: scenes that have next to nothing must build as well,
// and be drawn right.
#include "kernels/on_device.h"
#include "kernels/worst.h"
#include "reference/reference.h"
#include "reference/scenes.h"
#include "scene/stages.h"

namespace stagelight {
namespace {

using namespace reference;

constexpr Settings small{.width = 24, .height = 16, .max_depth = 3};

// Each picture of the stages against the reference, away from edges, within the 1/255 that the
// golden pictures are held to.
void expect_drawn(const cl::Device &device, const Scene &scene, int stage,
                  Interior interior = Interior::full) {
    const RenderSettings settings{
        .width = small.width,
        .height = small.height,
        .max_depth = small.max_depth,
        .methods = {{"interior", interior == Interior::paper ? "paper" : "full"}},
        .kernels = {}};
    const std::string &name = stage_name(stage);
    Settings with = small;
    with.interior = interior;
    const Result truth = render<double>(scene, with);
    const Image image = Renderer(device, name, scene, settings).render().image;
    Worst pixels("pixels of " + name);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        if (truth.edge[i] == 0) {
            pixels.compare(i, dvec3(image.pixels[i]), dvec3(truth.image.pixels[i]), 1.0 / 255);
        }
    }
    pixels.expect(100);
}

Scene room() {
    Scene scene;
    scene.background = {0.25, 0.5, 0.75};
    scene.camera = {.position = {0, 1, 4}, .look_at = {0, 0.5, 0}};
    return scene;
}

Scene with_sphere(const Material &material) {
    Scene scene = room();
    add_sphere(scene, {0, 0.5, 0}, 1, material);
    return scene;
}

using KernelsStage02Builds = OnDevice;
INSTANTIATE_TEST_SUITE_P(On, KernelsStage02Builds, each_device(), device_name);
using KernelsStage03Builds = OnDevice;
INSTANTIATE_TEST_SUITE_P(On, KernelsStage03Builds, each_device(), device_name);
using KernelsStage04Builds = OnDevice;
INSTANTIATE_TEST_SUITE_P(On, KernelsStage04Builds, each_device(), device_name);
using KernelsStage05Builds = OnDevice;
INSTANTIATE_TEST_SUITE_P(On, KernelsStage05Builds, each_device(), device_name);
using KernelsStage06Builds = OnDevice;
INSTANTIATE_TEST_SUITE_P(On, KernelsStage06Builds, each_device(), device_name);

TEST_P(KernelsStage02Builds, WithoutALight) {
    expect_drawn(device(), with_sphere(diffuse({1, 1, 1})), 2);
}

TEST_P(KernelsStage03Builds, WithoutADiffuseMaterial) {
    Scene scene = with_sphere(mirror({0.9, 0.8, 0.7}));
    expect_drawn(device(), scene, 3);
    add_directional_light(scene, {0, -1, 0}, {1, 1, 1}, 1);  // lights nothing
    expect_drawn(device(), scene, 3);
}

TEST_P(KernelsStage04Builds, WithoutADielectric) {
    Scene scene = with_sphere(diffuse({0.9, 0.8, 0.7}));
    add_directional_light(scene, {0, -1, 0}, {1, 1, 1}, 1);
    expect_drawn(device(), scene, 4);
}

// With no sphere at all, and where the sphere that has the plane's index is of no interest: the
// paper's way is for spheres.
TEST_P(KernelsStage04Builds, WithAPlaneOfGlass) {
    for (const Interior interior : {Interior::full, Interior::paper}) {
        Scene scene = room();
        add_plane(scene, {0, 1, 0}, {0, 0, 0}, glass({0.9, 0.8, 0.7}, 1.5, {0.1, 0.2, 0.3}));
        add_plane(scene, {0, 1, 0}, {0, -1, 0}, mirror({0.9, 0.9, 0.9}));
        expect_drawn(device(), scene, 4, interior);
        add_sphere(scene, {0, 1, 0}, 0.5, glass({1, 1, 1}, 1.5, {0, 1, 1}));
        expect_drawn(device(), scene, 4, interior);
    }
}

TEST_P(KernelsStage05Builds, WithNothingButTriangles) {
    Scene scene = room();
    add_flat_triangle(scene, {-3, -1, -1}, {3, -1, -1}, {0, 3, -1},
                      add_material(scene, diffuse({0.9, 0.8, 0.7})));
    expect_drawn(device(), scene, 5);
    add_point_light(scene, {0, 2, 2}, {1, 1, 1}, 4);
    expect_drawn(device(), scene, 5);
}

TEST_P(KernelsStage06Builds, WithATextureOnNothingButASphere) {
    Material material = mirror({1, 1, 1});
    material.texture = 0;
    Scene scene = with_sphere(material);
    scene.textures.push_back(texture_of(1, 1, {255, 128, 64, 255}));
    expect_drawn(device(), scene, 6);
}

}  // namespace
}  // namespace stagelight
