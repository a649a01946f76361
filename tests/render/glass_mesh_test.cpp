// SPDX-License-Identifier: MIT
// Stage 11: glass of any closed shape, against answers worked out by hand and against the sphere.
#include "reference/glass_slab.h"
#include "reference/reference.h"
#include "render/on_each_device.h"
#include "scene/radiance_bound.h"

namespace stagelight::render {
namespace {

class Stage11Glass : public OnEachDevice {};
INSTANTIATE_TEST_SUITE_P(Devices, Stage11Glass, each_device(), device_name);

constexpr auto stage = "11_full_tracer";

// Off by no more than what was cut off (stage 11 says how much that may be) and a few roundings.
TEST_P(Stage11Glass, ASlabBendsSplitsAndAbsorbs) {
    for (const double angle : {0.0, 0.4, 0.9, 1.3}) {
        const GlassSlab slab{.angle = angle};
        Scene scene = slab.scene();
        scene.width = scene.height = 1;
        RenderSettings settings = settings_of(scene);
        for (const bool exact : {false, true}) {
            settings.methods = {{"fresnel", exact ? "exact" : "schlick"}};
            const Frame frame = renderer(stage, scene, settings).render();
            const double F = exact ? fresnel_at(angle, slab.ior) : schlick_at(angle, slab.ior);
            expect_color(frame.image, 0, 0, slab.seen(F),
                         frame.rays.cut_off_weight * radiance_bound(scene) + few_roundings);
        }
    }
}

// The mesh is drawn as the reference draws it, off the edges, and both are near to the sphere.
TEST_P(Stage11Glass, AFineBallIsNearTheSphere) {
    const Scene ball = glass_ball(64);
    const reference::Settings settings{.width = ball.width, .height = ball.height};
    const Image picture = draw(stage, ball).image;
    const auto truth = reference::render<double>(ball, settings);
    for (std::size_t i = 0; i < truth.edge.size(); ++i) {
        if (truth.edge[i] == 0) {
            expect_near(picture.pixels[i], truth.image.pixels[i], 1.0 / 1024);
        }
    }
    const auto sphere = reference::render<double>(glass_ball(), settings);
    EXPECT_LT(mean_difference(picture.pixels, sphere.image.pixels), 5e-4);
}

}  // namespace
}  // namespace stagelight::render
