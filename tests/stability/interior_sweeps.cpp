// SPDX-License-Identifier: MIT
// How far pictures of glass spheres are off by each way through them, index by index. The truth is
// the reference in double, which follows every inner reflection.
#include <cmath>

#include "reference/reference.h"
#include "render/on_each_device.h"
#include "stability/sweep.h"

namespace stagelight::stability {
namespace {

class StabilityStage04Interior : public render::OnEachDevice {};
INSTANTIATE_TEST_SUITE_P(On, StabilityStage04Interior, render::each_device(), render::device_name);

constexpr double indices[] = {1.01, 1.05, 1.1, 1.2, 1.33, 1.5, 1.8, 2.5};
constexpr int count = int(std::size(indices));
constexpr int side = 24;  // pixels, of the square around a sphere

// A row of spheres over a lit floor, each in a square of its own.
Scene row_of_spheres() {
    Scene scene;
    scene.width = side * count;
    scene.height = side;
    scene.camera.position = {0, 0.5, 3.0 * count};
    scene.camera.look_at = {0, 0, 0};
    scene.camera.fov = glm::degrees(2 * std::atan(0.5));
    scene.background = {0.3, 0.5, 0.9};
    for (int i = 0; i < count; ++i) {
        reference::add_sphere(scene, {3 * (i - (count - 1) / 2.0), 0, 0}, 1,
                              reference::glass({1, 1, 1}, indices[i], {0.2, 0.1, 0.05}));
    }
    reference::add_plane(scene, {0, 1, 0}, {0, -1.1, 0}, reference::diffuse({0.8, 0.6, 0.4}));
    reference::add_directional_light(scene, glm::normalize(glm::dvec3(1, -2, -1)), {1, 1, 1}, 1);
    return scene;
}

// Of all pixels around a sphere.
double rms_error(const Image &is, const Image &truth, int sphere) {
    double sum = 0;
    for (int y = 0; y < side; ++y) {
        for (int x = sphere * side; x < (sphere + 1) * side; ++x) {
            const glm::dvec3 off(is.at(x, y) - truth.at(x, y));
            sum += glm::dot(off, off) / 3;
        }
    }
    return std::sqrt(sum / (side * side));
}

TEST_P(StabilityStage04Interior, IndexByIndex) {
    const Scene scene = row_of_spheres();
    static const Image truth =  // for both devices
        reference::render<double>(scene, {scene.width, scene.height, scene.max_depth}).image;
    Sweep sweep({.name = "interior",
                 .kind = "interior",
                 .title = "Spheres of glass",
                 .x_label = "index of refraction",
                 .y_label = "RMS error of the picture",
                 .limit = 1.0 / 255,
                 .stated = "any index"},
                GetParam());
    for (const char *method : {"paper", "full"}) {
        RenderSettings settings = render::settings_of(scene);
        settings.methods = {{"interior", method}};
        const Frame frame = renderer("04_refraction_beer", scene, settings).render();
        for (int i = 0; i < count; ++i) {
            sweep.add(method, indices[i], rms_error(frame.image, truth, i));
        }
    }
    sweep.expect_holds("full", 2.5);
    sweep.expect_fails("paper", 1.01);  // by two codes at least, and by eight at 2.5
}

}  // namespace
}  // namespace stagelight::stability
