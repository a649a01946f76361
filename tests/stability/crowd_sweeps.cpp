// SPDX-License-Identifier: MIT
// Scenes in which many things are in one place: they end, without NaN, and are the reference's.
#include "image/compare.h"
#include "reference/reference.h"
#include "render/on_each_device.h"

namespace stagelight::stability {
namespace {

using glm::dvec3;

class StabilityStage11Crowd : public render::OnEachDevice {
protected:
    static void expect_reference(const Scene &scene) {
        RenderSettings settings = render::settings_of(scene);
        settings.methods = {{"width", "1"}};
        const Frame frame = renderer("11_full_tracer", scene, settings).render();
        const auto truth =
            reference::render<double>(scene, {scene.width, scene.height, scene.max_depth});
        const Comparison comparison = compare(frame.image, truth.image, truth.edge, {});
        EXPECT_EQ(comparison.failure, "") << to_string(comparison);
        EXPECT_LT(comparison.edge_pixels, scene.width * scene.height * 2 / 3);
    }

    static Scene small(dvec3 position, dvec3 look_at) {
        Scene scene = render::one_pixel(position, look_at);
        scene.width = 32;
        scene.height = 20;
        scene.max_depth = 4;
        scene.background = {0.2, 0.3, 0.5};
        return scene;
    }
};
INSTANTIATE_TEST_SUITE_P(On, StabilityStage11Crowd, render::each_device(), render::device_name);

// No tree can tell them apart; and what one reflects, none of the others may stop.
TEST_P(StabilityStage11Crowd, FourThousandTrianglesInOnePlace) {
    Scene scene = small({0, 0.5, 3}, {0, 0, 0});
    const int material = reference::add_material(scene, reference::mirror({0.9, 0.5, 0.2}));
    for (int i = 0; i < 4096; ++i) {
        reference::add_flat_triangle(scene, {-1.1, -0.9, 0}, {1.2, -0.7, 0.3}, {0.1, 1.3, -0.2},
                                     material);
    }
    expect_reference(scene);
}

// As many as rays remember. The lights: at the eye, on the floor, and inside of a ball that lets
// none out.
TEST_P(StabilityStage11Crowd, ThirtySpheresInOneAnotherAndLightsInOddPlaces) {
    Scene scene = small({0, 1, 4}, {0, 0.6, 0});
    for (int i = 0; i < 30; ++i) {
        reference::add_sphere(scene, {-0.8, 0.9, 0}, 0.8 - i * 0.01,
                              reference::glass({1, 1, 1}, 1.5, {0.2, 0.1, 0.05}));
    }
    reference::add_sphere(scene, {1, 1, 0}, 0.7, reference::diffuse({0.9, 0.4, 0.3}));
    reference::add_plane(scene, {0, 1, 0}, {0, 0, 0}, reference::diffuse({0.8, 0.8, 0.8}));
    reference::add_point_light(scene, scene.camera.position, {1, 1, 1}, 4);
    reference::add_point_light(scene, {0.5, 0, 1.5}, {0, 1, 0}, 1);
    reference::add_point_light(scene, {1, 1.1, 0}, {0, 0, 1}, 1);
    expect_reference(scene);
}

}  // namespace
}  // namespace stagelight::stability
