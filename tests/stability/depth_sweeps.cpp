// SPDX-License-Identifier: MIT
// What is lost between two mirrors that face each other when rays end too early. The truth is
// closed: at each bounce the share s of the light goes on, and 1 - s is what a lit wall sends at
// once; summed up without end that is the light of one wall that reflects nothing. Ended after
// `depth` bounces, s^(depth + 1) of it is lost; and up to 1 / 4096 where rays are cut off.
#include <cmath>

#include "reference/camera.h"
#include "render/on_each_device.h"
#include "stability/sweep.h"

namespace stagelight::stability {
namespace {

using glm::dvec3;

class StabilityStage11Depth : public render::OnEachDevice {};
INSTANTIATE_TEST_SUITE_P(On, StabilityStage11Depth, render::each_device(), render::device_name);

// What a wall lets go by: 1 / x.
constexpr double all_x[] = {2, 3, 5, 10, 20, 1000};

// Around the eye and its light, 1 off, a pair of walls for each x, across the ray of a pixel.
Scene pairs_of_walls(int max_depth) {
    Scene scene = render::one_pixel({0, 0, 0}, {0, 0, -1});
    scene.camera.fov = 120;
    scene.width = int(std::size(all_x));
    scene.max_depth = max_depth;
    reference::add_point_light(scene, {0, 0, 0}, {1, 1, 1}, 1);
    for (int pixel = 0; pixel < scene.width; ++pixel) {
        const dvec3 way =
            reference::primary_ray(scene.camera, scene.width, 1, pixel + 0.5, 0.5).direction;
        const double share = 1 - 1 / all_x[pixel];
        reference::add_plane(scene, -way, way, reference::glossy({1, 1, 1}, share));
        reference::add_plane(scene, way, -way, reference::glossy({1, 1, 1}, share));
    }
    return scene;
}

TEST_P(StabilityStage11Depth, MirrorsThatFaceEachOther) {
    Sweep sweep({.name = "depth",
                 .kind = "depth",
                 .title = "Mirrors that face each other",
                 .x_label = "1 / (1 - reflected share)",
                 .y_label = "light that is lost",
                 .limit = 1.0 / 255,
                 .stated = "what reflects 0.9, with depth 64"},
                GetParam());
    const auto measure = [&](const std::string &name, const char *stage, int depth,
                             const Methods &methods) {
        const Scene scene = pairs_of_walls(depth);
        RenderSettings settings = render::settings_of(scene);
        settings.methods = methods;
        const Frame frame = renderer(stage, scene, settings).render();
        for (int pixel = 0; pixel < scene.width; ++pixel) {
            const double x = all_x[pixel], lost = 1 - double(frame.image.at(pixel, 0).x);
            const double cutoff = methods.contains("depth") ? 0 : 1.0 / cutoff_one_in;
            EXPECT_NEAR(lost, std::pow(1 - 1 / x, depth + 1), cutoff + render::few_roundings)
                << name << " at " << x;
            sweep.add(name, x, std::abs(lost));
        }
    };
    // Stage 03 knows no other way, and is built in no time.
    for (const int depth : {8, 16, 32, 64}) {
        measure("fixed " + std::to_string(depth), "03_reflection_glossy", depth,
                {{"depth", "fixed"}});
    }
    measure("contribution", "11_full_tracer", 64, {{"width", "1"}});
    sweep.expect_holds("fixed 8", 2);
    sweep.expect_fails("fixed 8", 3);
    sweep.expect_holds("fixed 16", 3);
    sweep.expect_fails("fixed 16", 5);
    sweep.expect_holds("fixed 32", 5);
    sweep.expect_fails("fixed 32", 10);
    for (const char *method : {"fixed 64", "contribution"}) {
        sweep.expect_holds(method, 10);
        sweep.expect_fails(method, 20);
    }
}

}  // namespace
}  // namespace stagelight::stability
