// SPDX-License-Identifier: MIT
// Stage 10: glass of any closed shape, against answers worked out by hand and against the sphere.
#include "reference/glass_slab.h"
#include "reference/reference.h"
#include "render/on_each_device.h"

namespace stagelight::render {
namespace {

class Stage10Glass : public OnEachDevice {};
INSTANTIATE_TEST_SUITE_P(Devices, Stage10Glass, each_device(), device_name);

constexpr auto stage = "10_full_tracer";

TEST_P(Stage10Glass, ASlabBendsSplitsAndAbsorbs) {
    for (const double angle : {0.0, 0.4, 0.9, 1.3}) {
        const GlassSlab slab{.angle = angle};
        Scene scene = slab.scene();
        scene.width = scene.height = 1;
        RenderSettings settings = settings_of(scene);
        const Image by_schlick = renderer(stage, scene, settings).render().image;
        expect_color(by_schlick, 0, 0, slab.seen(schlick_at(angle, slab.ior)));
        settings.methods = {{"fresnel", "exact"}};
        const Image by_fresnel = renderer(stage, scene, settings).render().image;
        expect_color(by_fresnel, 0, 0, slab.seen(fresnel_at(angle, slab.ior)));
    }
}

// The mesh is drawn as the reference draws it, off the edges, and both are near to the sphere.
TEST_P(Stage10Glass, AFineBallIsNearTheSphere) {
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
